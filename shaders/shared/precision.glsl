// What may be held in 16 bits. Mali computes `mediump` in halves, twice as fast and in half the registers; 11
// significant bits are enough for radiance, colours, opacity and the weights between texels. Positions, voxel
// coordinates, distances, levels, depth and packed words are always highp, and so is what decides (an alpha
// cutoff, lit or not) and what is stored in 8 bits: a half would move some values to the next step, and the mips
// make up to 1/31 of full scale of a voxel's step.
//
// A value is rounded where it is assigned: mediump vec3 c = HALF(a * b). HALF does nothing but under
// VCT_EMULATE_HALF, which shows on any driver what a phone computes. VCT_FULL_PRECISION is for drivers that run on
// the CPU: llvmpipe rounds mediump for real, in software, and the cones take up to twice as long.
#ifdef VCT_FULL_PRECISION
#define mediump highp
#endif

#ifdef VCT_EMULATE_HALF
#define mediump highp
// To nearest, ties to even, as IEEE 754 has it; packHalf2x16 may cut the lower bits off instead. The range of a half
// is not emulated: the cones' values end at 6e4 (the sky's, frame_uniforms.cpp), and below 2^-14 absolute errors
// stay under 2^-25.
vec4 roundToHalf(vec4 v) {
    uvec4 bits = floatBitsToUint(v);
    return uintBitsToFloat((bits + 0xFFFu + ((bits >> 13) & 1u)) & 0xFFFFE000u);
}
vec3 roundToHalf(vec3 v) {
    uvec3 bits = floatBitsToUint(v);
    return uintBitsToFloat((bits + 0xFFFu + ((bits >> 13) & 1u)) & 0xFFFFE000u);
}
float roundToHalf(float v) {
    uint bits = floatBitsToUint(v);
    return uintBitsToFloat((bits + 0xFFFu + ((bits >> 13) & 1u)) & 0xFFFFE000u);
}
#define HALF(value) roundToHalf(value)
#else
#define HALF(value) (value)
#endif
