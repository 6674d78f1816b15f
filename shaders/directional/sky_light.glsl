// The sky in the received light. Where it is the same in all directions, how much of it a face sees says what it receives of
// it; of a picture of all directions it is what the cones saw. skyWord(): what is added to the sums of a step; skySum(): such a
// sum.
#include "directional/face_irradiance.glsl"
#include "shared/sky.glsl"

#ifdef VCT_ENVIRONMENT
#define VCT_SKY_SUMS 3u
#define SkySeen vec3  // relative to frame.radianceRange
SkySeen skySeen(vec3 direction, float solidAngle, float transmittance) {
    if (transmittance == 0.0) return vec3(0.0);
    return skyTowards(direction, solidAngle) * (transmittance / frame.radianceRange);
}
vec3 skyLight(SkySeen seen) {
    return seen;
}
float skyWord(SkySeen seen, uint i) {
    return seen[i];
}
SkySeen skySum(uint at) {
    return vec3(faceIrradianceData[at], faceIrradianceData[at + 1u], faceIrradianceData[at + 2u]);
}
#else
#define VCT_SKY_SUMS 1u
#define SkySeen float  // of the hemisphere
SkySeen skySeen(vec3 direction, float solidAngle, float transmittance) {
    return transmittance;
}
vec3 skyLight(SkySeen seen) {
    return seen * frame.skyRadiance.rgb / frame.radianceRange;
}
float skyWord(SkySeen seen, uint i) {
    return seen;
}
SkySeen skySum(uint at) {
    return float(faceIrradianceData[at]);
}
#endif
