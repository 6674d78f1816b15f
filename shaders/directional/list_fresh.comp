// Lists the static faces that have no light yet, where the faces that light steps visit will be
// (list_visited.comp). Only with cascades.
#include "directional/face_lists.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

void main() {
    uint words = (faceCount(0u) + 31u) / 32u;
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint word = gl_GlobalInvocationID.x; word < words; word += stride) {
        uint fresh = faceData[freshAt(32u * word)];
        if (fresh == 0u) continue;
        uint i = reserveFaces(uint(VCT_LIST_VISITED), uint(bitCount(fresh)));
        for (uint left = fresh; left != 0u; left &= left - 1u, ++i)
            if (i < commands[VCT_LIST_VISITED].faceCapacity)
                faceData[commands[VCT_LIST_VISITED].firstFace + i] = 32u * word + uint(findLSB(left));
    }
}
