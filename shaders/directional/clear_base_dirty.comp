// Empties the base level where something moves: static voxels in dirty blocks keep their places in the list, and what moved
// is gone.
#include "directional/clear_voxel.glsl"
#include "directional/static_entries.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

void main() {
    COUNT(VCT_COUNTER_FACE_CLEAR_BASE);
    uint count = visitedOf(activeVoxelCount(level));
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_FACE_CLEAR_BASE_VOXEL);
        ivec3 voxel = ivec3(visitedVoxel(level, i));
        uint slot = texelFetch(index, voxel, 0).r - 1u;
        if (slot >= firstMoving) imageStore(voxels, voxel, uvec4(0u));
        if (slot >= voxelPlaces()) continue;
        clearFaces(voxel, slot);
        setMarks(slot, 0u, staticFaces(slot));
    }
}
