// First of two passes over the triangles: which voxels are occupied. The first fragment of a voxel appends it to the
// list; the place in the list is where the second pass adds up what the voxel holds.
#include "shared/counters.glsl"
#include "shared/material.glsl"
#include "shared/frame.glsl"
#include "shared/commands.glsl"

in vec3 fragmentPosition;

// 0: empty, else the place in the list + 1. While that is being found out it is 1, which the maximum then replaces.
layout(r32ui, binding = VCT_IMAGE_VOXELS) coherent uniform uimage3D index;

void main() {
    COUNT(VCT_COUNTER_FACE_TOUCH);
    if (materialHasHoles && materialIsHole(materialBaseColor().a)) discard;
    ivec3 voxel = clamp(ivec3(floor(fragmentPosition * float(frame.gridSide))), ivec3(0), ivec3(frame.gridSide - 1));
    if (imageAtomicMax(index, voxel, 1u) == 0u) imageAtomicMax(index, voxel, appendVoxel(0u, uvec3(voxel)) + 1u);
}
