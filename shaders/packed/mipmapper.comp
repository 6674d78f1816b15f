// Computes one mip level of the packed voxels, over the active voxels only (thesis 4.5, algorithm 8). Each
// voxel adds itself to its parent with one atomic operation; the first child appends the parent to the next
// list.
#include "shared/commands.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(r32ui, binding = VCT_IMAGE_VOXELS) readonly uniform uimage3D voxels;
layout(r32ui, binding = VCT_IMAGE_VOXELS_NEXT) uniform uimage3D parents;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;

void main() {
    uint count = activeVoxelCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uvec3 voxel = activeVoxel(level, i);
        uint word = imageLoad(voxels, ivec3(voxel)).r;
        uvec3 parent = voxel >> 1u;
        if (imageAtomicAdd(parents, ivec3(parent), childContribution(word)) == 0u)
            appendVoxel(level + 1u, parent);
    }
}
