// Directional coverage voxels: six faces per voxel in one filterable 3D texture. Face f (a direction along an axis)
// holds, of the surface in the voxel that looks towards f: alpha, the share of the voxel's cross-section that it
// covers, and rgb, its radiance relative to E/pi over faceRange.radiance, premultiplied by alpha. One-sided: a
// surface seen from behind neither lights nor blocks.
//
// The texture has 3 x 2 blocks of the grid: the axis along x, the side along y (0: towards +axis, 1: towards -axis).
#include "shared/layout.h"

// Of one face's block, in blocks.
ivec2 faceBlock(int axis, int side) {
    return ivec2(axis, side);
}

ivec3 faceTexel(ivec3 voxel, int axis, int side, int gridOfLevel) {
    return voxel + ivec3(faceBlock(axis, side) * gridOfLevel, 0);
}

// Noise in 0..1 per channel that follows from the place and the number of the light step alone (Jarzynski and Olano
// 2020, pcg).
vec3 hashNoise(ivec3 texel, uint frameIndex) {
    uint h = uint(texel.x) + 1024u * (uint(texel.y) + 1024u * uint(texel.z)) + 2654435769u * frameIndex;
    h = h * 747796405u + 2891336453u;
    h = ((h >> ((h >> 28u) + 4u)) ^ h) * 277803737u;
    h = (h >> 22u) ^ h;
    return vec3(h & 1023u, h >> 10u & 1023u, h >> 20u & 1023u) / 1024.0;
}

// A face as it is stored in 8 bits: rgb is dithered, so that dim light is right in the mean and does not vanish; coverage is
// rounded to nearest. The dither differs from step to step, and the mean over the steps is as much finer: 8 bits then span a
// lamp and the third bounce of its light.
vec4 ditherToUnorm8(vec4 value, ivec3 texel, uint frameIndex) {
    return vec4(floor(value.rgb * 255.0 + hashNoise(texel, frameIndex)) / 255.0, value.a);
}
