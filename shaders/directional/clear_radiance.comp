// Before the same surfaces are lit anew: the faces of the base level lose their radiance, in the sums.
#include "shared/counters.glsl"
#include "directional/face_list.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 0

void main() {
    COUNT(VCT_COUNTER_FACE_DARKEN);
    uint count = min(activeVoxelCount(level), voxelPlaces());
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint slot = gl_GlobalInvocationID.x; slot < count; slot += stride) {
        COUNT(VCT_COUNTER_FACE_DARKEN_VOXEL);
        for (uint left = markedFaces(slot); left != 0u; left &= left - 1u) {
            COUNT(VCT_COUNTER_FACE_DARKEN_FACE);
            uint index = faceSumIndex(slot, findLSB(left)) + VCT_FACE_SUM_RADIANCE;
            for (uint channel = 0u; channel < 3u; ++channel)
                faceSums[index + channel] = 0u;
        }
    }
}
