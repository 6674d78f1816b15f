// The faces that the passes of a light step visit: all faces, or while only cascades move, the active ones
// that directional/choose_faces.comp lists. Their list grows from the end of the buffer, towards that of the
// faces that gather.
#include "directional/face_lists.glsl"
#include "directional/gather_turns.glsl"

uint visitedFaceCount(bool everyFace) {
    return everyFace ? baseFaceCount() : faceIrradianceData[lightSums(lightStep.frame) + VCT_SUM_ACTIVE];
}
uint visitedFaceId(bool everyFace, uint i) {
    return everyFace ? baseFaceId(i) : faceIrradianceData[lightStep.lastActiveFace - i];
}
