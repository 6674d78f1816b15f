// Lists the static faces that mark_walls.comp and link_faces.comp visit after cascades have moved: those that
// have other faces around them since. The list is that of the faces which light steps visit;
// list_visited.comp writes that one later. Only with cascades.
#include "directional/face_lists.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_ARRIVED) uniform uvec2 arrived[VCT_MAX_CASCADES];  // isNearArrived()

void main() {
    const int reach = 8;  // from a wall to the bricks in which it is marked, in voxels
    uint count = faceCount(0u);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint id = gl_GlobalInvocationID.x; id < count; id += stride) {
        ListedFace listed = baseFace(id);
        if (listed.isMerged || !isNearArrived(listed.voxel, 1, arrived[cascadeOf(listed.voxel)], reach))
            continue;
        uint i = reserveFaces(uint(VCT_LIST_VISITED), 1u);
        if (i < commands[VCT_LIST_VISITED].faceCapacity)
            faceData[commands[VCT_LIST_VISITED].firstFace + i] = id;
    }
}
