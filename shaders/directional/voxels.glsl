// Directional voxels: six faces per voxel in one filterable 3D texture. A face describes the surfaces in the
// voxel that face its direction. Alpha is coverage, the share of the voxel's cross-section that they cover.
// rgb is their radiance, relative to E/pi and divided by faceRange.radiance, premultiplied by alpha. Faces
// are one-sided: seen from behind, they neither emit nor block light.
//
// The texture has 3 x 2 blocks of grid^3 texels: axes along x, sides along y (0: towards +axis, 1: towards
// -axis).
#include "shared/layout.h"

// The position of a face direction's block in the texture, in blocks.
ivec2 faceBlock(int axis, int side) {
    return ivec2(axis, side);
}

ivec3 faceTexel(ivec3 voxel, int axis, int side, int gridOfLevel) {
    return voxel + ivec3(faceBlock(axis, side) * gridOfLevel, 0);
}

// Noise in 0..1 per channel, a hash of the texel and the number of the light step (Jarzynski and Olano 2020,
// pcg).
vec3 hashNoise(ivec3 texel, uint frameIndex) {
    uint h = uint(texel.x) + 1024u * (uint(texel.y) + 1024u * uint(texel.z)) + 2654435769u * frameIndex;
    h = h * 747796405u + 2891336453u;
    h = ((h >> ((h >> 28u) + 4u)) ^ h) * 277803737u;
    h = (h >> 22u) ^ h;
    return vec3(h & 1023u, h >> 10u & 1023u, h >> 20u & 1023u) / 1024.0;
}

// Prepares a face for storage in 8 bits. rgb is dithered, so that dim light has the right mean and does not
// vanish; coverage is rounded by the driver. The dither differs from step to step, so the mean over steps is
// finer than 8 bits and spans a lamp and the third bounce of its light.
vec4 ditherToUnorm8(vec4 value, ivec3 texel, uint frameIndex) {
    return vec4(floor(value.rgb * 255.0 + hashNoise(texel, frameIndex)) / 255.0, value.a);
}
