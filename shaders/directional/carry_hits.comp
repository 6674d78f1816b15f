// Copies the hits of cached rays from the faces of the last pose that carry_over.comp has chosen. Ids of
// faces in the last pose are replaced by those in the new one. A ray that has hit a face which is not listed
// any more is traced again.
#include "directional/face_lists.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// The hit with the id that its face has in the new lists.
uint hitInNewLists(uint hit) {
    uint code = hit & ~VCT_HIT_NEAR, target = code - VCT_HIT_FACE, last = dynamicList ^ 1u;
    if (code < VCT_HIT_FACE) return hit;
    if (VCT_CASCADES > 1 && target < commands[0].faceCapacity) return isGone(target) ? VCT_HIT_UNKNOWN : hit;
    if (target - commands[last].firstId >= commands[last].faceCapacity) return hit;
    uint next = faceIrradianceData[forwardAt(target)];
    return next == 0u ? VCT_HIT_UNKNOWN : VCT_HIT_FACE + next - 1u | hit & VCT_HIT_NEAR;
}

void main() {
    uint count = faceCount(dynamicList);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = commands[dynamicList].firstId + i, from = cachedHit(id, 0u);
        uint known = 0u, backs = 0u;
        for (uint quad = 0u; quad < uint(VCT_DIRECTIONS) / 4u; ++quad) {
            uvec4 hits = uvec4(VCT_HIT_UNKNOWN);
            if (from != 0u) hits = cachedHits(from - 1u, quad);
            hits = uvec4(hitInNewLists(hits.x), hitInNewLists(hits.y), hitInNewLists(hits.z),
                         hitInNewLists(hits.w));
            storeCachedHits(id, quad, hits);
            uint unknown = uint(hits.x == VCT_HIT_UNKNOWN) + uint(hits.y == VCT_HIT_UNKNOWN) +
                           uint(hits.z == VCT_HIT_UNKNOWN) + uint(hits.w == VCT_HIT_UNKNOWN);
            uint counted = uint(countsInMean(hits.x)) + uint(countsInMean(hits.y)) +
                           uint(countsInMean(hits.z)) + uint(countsInMean(hits.w));
            known += counted;
            backs += 4u - counted - unknown;
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
