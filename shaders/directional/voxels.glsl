// The place of the faces of blocks in textures: 3 x 2 blocks of texels, axes along x, sides along y (0:
// towards +axis, 1: towards -axis).
#include "shared/layout.h"

ivec3 faceTexel(ivec3 block, int axis, int side, int blocks) {
    return block + ivec3(ivec2(axis, side) * blocks, 0);
}

// The components along the axes that a face spans, cyclically behind the axis that it looks along.
vec2 acrossFaces(vec3 v, int axis) {
    return axis == 0 ? v.yz : axis == 1 ? v.zx : v.xy;
}
// The vector with these components across the face and along its axis.
vec3 fromAcross(vec2 across, float along, int axis) {
    return axis == 0   ? vec3(along, across)
           : axis == 1 ? vec3(across.y, along, across.x)
                       : vec3(across, along);
}

// Noise in 0..1 per channel, a hash of a voxel and a number (Jarzynski and Olano 2020, pcg).
vec3 hashNoise(ivec3 voxel, uint number) {
    uint h = uint(voxel.x) + 1024u * (uint(voxel.y) + 1024u * uint(voxel.z)) + 2654435769u * number;
    h = h * 747796405u + 2891336453u;
    h = ((h >> ((h >> 28u) + 4u)) ^ h) * 277803737u;
    h = (h >> 22u) ^ h;
    return vec3(h & 1023u, h >> 10u & 1023u, h >> 20u & 1023u) / 1024.0;
}
