// One mip level of the faces where something moves: of the static faces those in dirty blocks, whose parents are listed,
// and those of what moves.
#include "directional/mipmap.glsl"
#include "directional/static_entries.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

void main() {
    COUNT(VCT_COUNTER_FACE_MIPMAPPER);
    uint count = visitedOf(faceCount(level));
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        ListedFace listed = visitedFace(level, i);
        storeMean(listed, 0u);
        if (isMoving(i)) listParentOf(listed);
    }
}
