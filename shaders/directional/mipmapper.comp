// One mip level of the faces from the one below, over that level's faces that are not empty. VCT_LIST_PARENTS (true or
// false): makes the next level's lists too; they last until the scene is voxelized again.
#include "directional/mipmap.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_WHICH) uniform uint which;  // time it is that the same faces are stored; 0 where listed

void main() {
    COUNT(VCT_COUNTER_FACE_MIPMAPPER);
    uint count = faceCount(level);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        ListedFace listed = listedFace(level, i);
        storeMean(listed, VCT_LIST_PARENTS ? 0u : which);
        if (VCT_LIST_PARENTS) listParentOf(listed);
    }
}
