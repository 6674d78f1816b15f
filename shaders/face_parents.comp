// The occupied voxels of the next level: the first child to arrive appends its parent to that level's list.
#include "shared/trips.glsl"
#include "shared/commands.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(r32ui, binding = VCT_IMAGE_VOXELS_NEXT) coherent uniform uimage3D parents;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;

void main() {
    TRIP(VCT_TRIPS_FACE_PARENTS);
    uint count = activeVoxelCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        TRIP(VCT_TRIPS_FACE_PARENTS_VOXEL);
        uvec3 parent = unpackEntry(activeVoxels[commands[level].firstEntry + i]) >> 1u;
        if (imageAtomicMax(parents, ivec3(parent), 1u) == 0u)
            imageAtomicMax(parents, ivec3(parent), appendVoxel(level + 1u, parent) + 1u);
    }
}
