// Copies the hits of cached rays from the faces of the last pose that carry_over.comp has chosen. Ids of
// faces in the last pose are replaced by those in the new one. A ray that has hit a face which is not listed
// any more is traced again.
#include "directional/face_lists.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// The faces of the last pose.
struct LastFaces {
    uint firstId, capacity;
};

// The hit with the id that its face has in the new lists.
uint hitInNewLists(uint hit, LastFaces last) {
    uint target = (hit & ~VCT_HIT_NEAR) - VCT_HIT_FACE, i = target - last.firstId;
#if VCT_CASCADES > 1
    if (target < commands[0].faceCapacity) return isGone(target) ? VCT_HIT_UNKNOWN : hit;
#endif
    // A word is read in any case, because a selection is cheaper than a branch.
    bool isOfLast = i < last.capacity;
    uint next = faceIrradianceData[forwardAt(last.firstId + (isOfLast ? i : 0u))];
    uint moved = next == 0u ? VCT_HIT_UNKNOWN : VCT_HIT_FACE + next - 1u | hit & VCT_HIT_NEAR;
    return isOfLast ? moved : hit;
}

void main() {
    uint count = faceCount(dynamicList), firstId = commands[dynamicList].firstId;
    uint lastList = dynamicList ^ 1u;
    LastFaces last = LastFaces(commands[lastList].firstId, commands[lastList].faceCapacity);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = firstId + i, from = cachedHit(id, 0u);
        uint unknown = 0u, backs = 0u;
        uint at = hitsAt(id, 0u), fromAt = hitsAt(max(from, 1u) - 1u, 0u);
        for (uint quad = 0u; quad < uint(VCT_DIRECTIONS) / 4u; ++quad) {
            uvec4 hits = cachedHitsFrom(fromAt, quad & 1u);
            if (from == 0u) hits = uvec4(VCT_HIT_UNKNOWN);
            hits = uvec4(hitInNewLists(hits.x, last), hitInNewLists(hits.y, last),
                         hitInNewLists(hits.z, last), hitInNewLists(hits.w, last));
            storeCachedHitsFrom(at, quad & 1u, hits);
            // The bit of a nearby hit is shifted out.
            vec4 isUnknown = vec4(equal(hits, uvec4(VCT_HIT_UNKNOWN)));
            vec4 isBack = vec4(equal(hits << codeShift, uvec4(VCT_HIT_BACK << codeShift)));
            unknown += uint(dot(isUnknown, vec4(1.0)));
            backs += uint(dot(isBack, vec4(1.0)));
            if ((quad & 1u) != 0u) {
                at += hitsStep;
                fromAt += hitsStep;
            }
        }
        uint known = uint(VCT_DIRECTIONS) - unknown - backs;
        // The means over the rays that are known, of those that hit the sky.
        FaceSight sight = faceSight(id);
        vec4 sky = faceMean(id, VCT_MEAN_SKY) * (float(sight.rays) / max(float(known), 1.0));
        storeFaceMean(id, VCT_MEAN_SKY, sky);
        sight.rays = known;
        sight.backs = backs;
        storeFaceSight(id, sight);
    }
}
