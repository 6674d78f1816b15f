// The base level where something moves: of the static voxels those in dirty blocks, and what moves. Faces of static voxels
// are listed already.
#include "directional/resolve.glsl"
#include "directional/static_entries.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0
layout(binding = VCT_TEX_VOXELS) uniform usampler3D index;

void main() {
    COUNT(VCT_COUNTER_FACE_RESOLVE);
    uint count = visitedOf(activeVoxelCount(level));
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        ivec3 voxel = ivec3(visitedVoxel(level, i));
        uint slot = texelFetch(index, voxel, 0).r - 1u;
        if (slot >= voxelPlaces()) continue;
        COUNT(VCT_COUNTER_FACE_RESOLVE_VOXEL);
        uint marked = markedFaces(slot);
        if (marked == 0u) continue;
        listVoxel(voxel, marked, marked & ~staticFaces(slot));
        storeFaces(voxel, slot, marked);
    }
}
