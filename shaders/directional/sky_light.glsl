// The sky's part of face irradiance. For a sky of one colour, cones accumulate the visible share of the
// hemisphere. For a sky that depends on direction, they accumulate its radiance.
#include "shared/sky.glsl"

#ifdef VCT_ENVIRONMENT
#define VisibleSky vec3  // relative to E/pi
VisibleSky visibleSky(vec3 direction, float solidAngle, float transmittance) {
    if (transmittance == 0.0) return vec3(0.0);
    return sampleSky(direction, solidAngle) * transmittance;
}
vec3 skyLight(VisibleSky seen) {
    return seen;
}
#else
#define VisibleSky float  // share of the hemisphere
VisibleSky visibleSky(vec3 direction, float solidAngle, float transmittance) {
    return transmittance;
}
vec3 skyLight(VisibleSky seen) {
    return seen * frame.skyRadiance.rgb;
}
#endif
