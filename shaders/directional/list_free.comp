// Lists the words of bits in which static ids are free, after scroll.comp, and counts the ids without a face:
// those, and the ones that are free from the next move on. The list is that of the faces which light steps
// visit; list_visited.comp writes that one later. Only with cascades.
#include "directional/face_lists.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

void main() {
    uint total = faceCount(0u), words = (total + 31u) / 32u;
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint word = gl_GlobalInvocationID.x; word < words; word += stride) {
        uint unused = 0u;
        for (uint id = 32u * word; id < min(32u * word + 32u, total); ++id)
            unused += uint(faceData[commands[0].firstFace + id] == VCT_FREE_FACE);
        if (unused == 0u) continue;
        atomicAdd(unusedIds, unused);
        if (faceData[commands[0].firstMask + word] == 0u) continue;
        faceData[commands[VCT_LIST_VISITED].firstFace + reserveFaces(uint(VCT_LIST_VISITED), 1u)] = word;
    }
}
