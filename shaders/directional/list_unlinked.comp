// Lists the static faces that link_faces.comp visits after cascades have moved: those that have other faces
// around them since. The list is that of the faces which light steps visit; list_visited.comp writes that one
// later. Only with cascades.
#include "directional/face_lists.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_SHIFT) uniform uint shifts[VCT_MAX_CASCADES];  // packShift(): their paths

void main() {
    const int reach = 2;  // of the links
    uint count = faceCount(0u);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint id = gl_GlobalInvocationID.x; id < count; id += stride) {
        ListedFace listed = baseFace(id);
        if (listed.isMerged) continue;
        int cascade = cascadeOf(listed.voxel);
        ivec3 path = unpackShift(shifts[cascade]), last = ivec3(frame.gridSide - 1);
        ivec3 inCascade = listed.voxel - ivec3(0, 0, cascade * frame.gridSide);
        // Faces have others around them near the cascade's borders along the axes of its path.
        bvec3 isNear = lessThan(min(inCascade, last - inCascade), path + reach);
        if (!any(bvec3(isNear.x && path.x > 0, isNear.y && path.y > 0, isNear.z && path.z > 0))) continue;
        uint i = reserveFaces(uint(VCT_LIST_VISITED), 1u);
        if (i < commands[VCT_LIST_VISITED].faceCapacity)
            faceData[commands[VCT_LIST_VISITED].firstFace + i] = id;
    }
}
