// The sky's part of face irradiance. For a sky of one colour, rays accumulate the visible share of the
// hemisphere. For a sky that depends on direction, they accumulate its radiance.
#include "shared/sky.glsl"

#ifdef VCT_ENVIRONMENT
#define VisibleSky vec3  // relative to E/pi
VisibleSky visibleSky(vec3 direction, float solidAngle) {
    return sampleSky(direction, solidAngle);
}
vec3 skyLight(VisibleSky seen) {
    return seen;
}
#else
#define VisibleSky float  // share of the hemisphere
VisibleSky visibleSky(vec3 direction, float solidAngle) {
    return 1.0;
}
vec3 skyLight(VisibleSky seen) {
    return seen * frame.skyRadiance.rgb;
}
#endif
