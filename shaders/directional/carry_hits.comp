// Copies the hits of cached rays from the faces of the last lists that carry_over.comp has chosen. Ids of
// faces in the last lists are replaced by those in the new lists; a ray that has hit a face which is not
// listed any more is traced again.
#include "directional/face_lists.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_LIST) uniform uint list;

bool isIn(uint id, uint oldList) {
    return id - commands[oldList].firstId < commands[oldList].faceCapacity;
}

void main() {
    COUNT(VCT_COUNTER_CARRY_HITS);
    uint count = faceCount(list);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_CARRY_HITS_FACE);
        uint id = commands[list].firstId + i, from = faceIrradianceData[hitAt(id, 0u)];
        uint known = 0u, backs = 0u;
        for (uint d = 0u; d < uint(VCT_DIRECTIONS); ++d) {
            COUNT(VCT_COUNTER_CARRY_HITS_HIT);
            uint hit = from == 0u ? VCT_HIT_UNKNOWN : faceIrradianceData[hitAt(from - 1u, d)];
            uint code = hit & ~VCT_HIT_NEAR;
            if (code >= VCT_HIT_FACE) {
                uint target = code - VCT_HIT_FACE;
                if (isIn(target, dynamicList ^ 1u) || VCT_CASCADES > 1 && isIn(target, staticList ^ 1u)) {
                    uint next = faceIrradianceData[forwardAt(target)];
                    hit = next == 0u ? VCT_HIT_UNKNOWN : VCT_HIT_FACE + next - 1u | hit & VCT_HIT_NEAR;
                }
            }
            faceIrradianceData[hitAt(id, d)] = hit;
            if (hit == VCT_HIT_UNKNOWN) continue;
            if ((hit & ~VCT_HIT_NEAR) == VCT_HIT_BACK)
                ++backs;
            else
                ++known;
        }
        // The means over the rays that are known, of those that hit the sky.
        FaceSight sight = faceSight(id);
        vec4 sky = faceMean(id, VCT_MEAN_SKY) * (float(sight.rays) / max(float(known), 1.0));
        storeFaceMean(id, VCT_MEAN_SKY, sky);
        storeFaceMean(id, VCT_MEAN_SKY_NOW, sky);
        sight.rays = known;
        sight.backs = backs;
        storeFaceSight(id, sight);
    }
}
