// The faces that a pass of a light step visits: all, or with cascades those of directional/list_visited.comp.
#include "directional/face_lists.glsl"
#include "directional/light_step.glsl"

#if VCT_CASCADES > 1
layout(location = VCT_UNIFORM_VISITS_ALL) uniform uint visitsAll;
uint visitedFaceCount() {
    return visitsAll != 0u ? baseFaceCount() : faceCount(uint(VCT_LIST_VISITED));
}
uint visitedFaceId(uint i) {
    return visitsAll != 0u ? baseFaceId(i) : faceData[commands[VCT_LIST_VISITED].firstFace + i];
}
#else
uint visitedFaceCount() {
    return baseFaceCount();
}
uint visitedFaceId(uint i) {
    return baseFaceId(i);
}
#endif
