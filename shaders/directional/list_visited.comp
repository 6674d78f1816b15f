// Lists the static faces that the next light steps visit after cascades have moved. Only with cascades.
#include "directional/face_lists.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_TURNS) uniform uint turnsLeft;  // of forward_hits.comp

void main() {
    uint count = faceCount(0u);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint id = gl_GlobalInvocationID.x; id < count; id += stride) {
        // All faces have light now, and no hit is of a face whose id another one has got. The first of the
        // ids that share a word clears it.
        if ((id & 31u) == 0u) {
            uint fresh = faceData[freshAt(id)];
            faceData[freshAt(id)] = 0u;
            faceData[goneAt(id)] = turnsLeft == 0u ? 0u : faceData[goneAt(id)] & ~fresh;
        }
        if (!hasChangedSince(id, lightStep.visitsSince - 1u) || baseFace(id).isMerged) continue;
        uint i = reserveFaces(uint(VCT_LIST_VISITED), 1u);
        if (i < commands[VCT_LIST_VISITED].faceCapacity)
            faceData[commands[VCT_LIST_VISITED].firstFace + i] = id;
    }
}
