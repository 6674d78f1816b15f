// Copies the sums of the static faces of the cascades that have not moved to the ids that the faces have in
// the present list.
#include "directional/face_lists.glsl"
#include "directional/face_sums.glsl"
#include "directional/cascades.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_PREVIOUS_VOXELS) uniform highp usampler3D previousIndex;
layout(location = VCT_UNIFORM_CASCADES) uniform uint moved;  // a bit per cascade

void main() {
    COUNT(VCT_COUNTER_KEEP_SUMS);
    uint count = faceCount(staticList);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_KEEP_SUMS_FACE);
        ListedFace listed = listedFace(staticList, i);
        if ((moved >> uint(cascadeOf(listed.voxel)) & 1u) != 0u) continue;
        uint cell = texelFetch(previousIndex, listed.voxel, 0).r;
        if (!hasFace(cell, listed.face)) continue;
        uint from = sumsAt(faceId(cell, listed.face)), to = sumsAt(commands[staticList].firstId + i);
        for (uint word = 0u; word < faceSumWords; ++word)
            faceSumData[to + word] = faceSumData[from + word];
    }
}
