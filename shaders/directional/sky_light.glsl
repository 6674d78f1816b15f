// The sky in the received light. Where it is the same in all directions, how much of it a face sees says what it receives of
// it; of a picture of all directions it is what the cones saw.
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
#define VisibleSky float  // of the hemisphere
VisibleSky visibleSky(vec3 direction, float solidAngle, float transmittance) {
    return transmittance;
}
vec3 skyLight(VisibleSky seen) {
    return seen * frame.skyRadiance.rgb;
}
#endif
