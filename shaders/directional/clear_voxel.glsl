// Empties what a voxel of the base level holds: its faces and their sums.
#include "shared/counters.glsl"
#include "directional/face_list.glsl"
#include "directional/voxels.glsl"

layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(r32ui, binding = VCT_IMAGE_VOXELS) writeonly uniform uimage3D voxels;
layout(binding = VCT_TEX_VOXELS) uniform usampler3D index;  // the same voxels

void clearFaces(ivec3 voxel, uint slot) {
    for (uint left = markedFaces(slot); left != 0u; left &= left - 1u) {
        COUNT(VCT_COUNTER_FACE_CLEAR_BASE_FACE);
        int face = findLSB(left);
        imageStore(faces, faceTexel(voxel, face >> 1, face & 1, frame.gridSide), vec4(0.0));
        uint sum = faceSumIndex(slot, face);
        for (uint word = 0u; word < VCT_FACE_SUM_WORDS; ++word)
            faceSums[sum + word] = 0u;
    }
}
