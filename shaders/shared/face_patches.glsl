// What bounces pass on. A patch is the surface in a block of voxels that looks one way; the level of the blocks is
// VCT_GATHER_FINEST_LEVEL or, where there is no gather, given by the caller. Light is relative to E/pi.
#include "shared/layout.h"

layout(std430, binding = VCT_SSBO_FACE_PATCHES) buffer FacePatchBlock {
    // First, what a bounce added to the light of all patches, red, green, blue, in fixed point with a sign: of the
    // bounce before, of this one, and of the next (zeroed by this one), in turn. Then the number of blocks, and per
    // place of the block in its level's list, per face, VCT_PATCH_*.
    uint facePatches[];
};

#define VCT_PATCH_MIDDLE 0u    // of the surface, in the block: packSteps()
#define VCT_PATCH_NORMAL 1u    // mean, times 0.5 plus 0.5: packSteps()
#define VCT_PATCH_DIRECT 2u    // the block's face without bounces: a texel of it
#define VCT_PATCH_COVERAGE 3u  // sum over the base level's faces, fixed point
#define VCT_PATCH_ALBEDO 4u    // three, likewise, premultiplied by coverage
#define VCT_PATCH_LIGHT 7u     // received, before albedo: three halves in two words
#define VCT_PATCH_BEFORE 9u    // the same, one bounce less

#define VCT_PATCH_UNITS 4096.0    // of fixed point: a block has at most 16^3 voxels (512^3)
#define VCT_ENERGY_UNITS 16384.0  // at most 32^3 blocks, half of whose faces shine

// The place in the buffer of the energies of a bounce.
uint bounceEnergy(uint bounce) {
    return bounce % 3u * 3u;
}

// `occupied`: of the block, in the image of occupied voxels.
uint patchIndex(uint occupied, int face) {
    return VCT_PATCH_HEADER + ((occupied >> VCT_FACE_MASK_BITS) * 6u + uint(face)) * VCT_PATCH_WORDS;
}

// How many blocks there is room for. (zink has no use for length() here: it returns too little.)
uint patchPlaces() {
    return facePatches[VCT_PATCH_PLACES];
}

// Three numbers in 0..1 in one word. 1022 steps: 0.5 is exact, so that a normal's 0 is 0 on every driver.
uint packSteps(vec3 value) {
    uvec3 steps = uvec3(value * 1022.0 + 0.5);
    return (steps.x << 20) | (steps.y << 10) | steps.z;
}

vec3 unpackSteps(uint word) {
    return (vec3(uvec3(word >> 20, (word >> 10) & 1023u, word & 1023u)) - 511.0) / 1022.0 + 0.5;
}

vec3 patchLight(uint index) {
    return vec3(unpackHalf2x16(facePatches[index]), unpackHalf2x16(facePatches[index + 1u]).x);
}

void storePatchLight(uint index, vec3 light) {
    facePatches[index] = packHalf2x16(light.xy);
    facePatches[index + 1u] = packHalf2x16(vec2(light.z, 0.0));
}

// Mean albedo of the surface.
vec3 patchAlbedo(uint patchAt) {
    uint index = patchAt + VCT_PATCH_ALBEDO;
    return vec3(uvec3(facePatches[index], facePatches[index + 1u], facePatches[index + 2u])) /
           max(float(facePatches[patchAt + VCT_PATCH_COVERAGE]), 1.0);
}
