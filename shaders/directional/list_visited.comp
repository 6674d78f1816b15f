// Lists the faces that the next light steps visit: static faces of some cascades, those that a move of
// cascades has changed, those near moving objects, and all dynamic ones. Only with cascades.
#include "directional/changed.glsl"
#include "directional/face_lists.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_TURNS) uniform uint turnsLeft;  // of forward_hits.comp

void main() {
    uint count = baseFaceCount(), staticCount = faceCount(0u);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint n = gl_GlobalInvocationID.x; n < count; n += stride) {
        uint id = baseFaceId(n);
        bool isStatic = n < staticCount;
        // All faces have light now, and no hit is of a face whose id another one has got. The first of the
        // ids that share a word clears it.
        if (isStatic && (id & 31u) == 0u) {
            uint fresh = faceData[freshAt(id)];
            faceData[freshAt(id)] = 0u;
            faceData[goneAt(id)] = turnsLeft == 0u ? 0u : faceData[goneAt(id)] & ~fresh;
        }
        ListedFace listed = baseFace(id);
        if (listed.isMerged) continue;
        if (isStatic && !hasChangedSince(id, lightStep.visitsSince - 1u) &&
            (lightStep.visitedCascades >> uint(cascadeOf(listed.voxel)) & 1u) == 0u &&
            isUnchanged(id, listed.voxel))
            continue;
        uint i = reserveFaces(uint(VCT_LIST_VISITED), 1u);
        if (i < commands[VCT_LIST_VISITED].faceCapacity)
            faceData[commands[VCT_LIST_VISITED].firstFace + i] = id;
    }
}
