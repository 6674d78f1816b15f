// The base level: the sums of each occupied voxel into the texels of its faces, and the lists of the faces and of their
// parents. VCT_STATIC (true or false): of the static geometry alone, where something else moves, whose faces stay listed
// from then on.
#include "directional/resolve.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

void main() {
    COUNT(VCT_COUNTER_FACE_RESOLVE);
    uint count = min(activeVoxelCount(level), voxelPlaces());
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint slot = gl_GlobalInvocationID.x; slot < count; slot += stride) {
        COUNT(VCT_COUNTER_FACE_RESOLVE_VOXEL);
        ivec3 voxel = ivec3(activeVoxel(level, slot));
        uint marked = markedFaces(slot);
        if (marked == 0u) continue;
        listVoxel(voxel, marked, marked);
        if (VCT_STATIC) setMarks(slot, marked, marked);
        storeFaces(voxel, slot, marked);
    }
}
