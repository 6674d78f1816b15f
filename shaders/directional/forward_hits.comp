// After cascades have moved, lets the cached rays of static faces whose hits are gone hit the faces of the
// next cascade in their place. Rays for which there is none are unknown. The faces take turns, one of which
// comes in each step, because a face that is gone keeps its radiance until its id is used again. Only with
// cascades.
#include "directional/face_lists.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_CASCADES) uniform uint moved;  // a bit per cascade
layout(location = VCT_UNIFORM_TURNS) uniform uint turns;     // that come in this dispatch

// True if the static face that a ray has hit is gone. One bit tells it, so that a cache holds those of all
// faces.
bool isLost(uint hit) {
    uint id = (hit & ~VCT_HIT_NEAR) - VCT_HIT_FACE;  // a large number if the ray has hit no face
    if (id >= commands[0].faceCapacity) return false;
    return (faceData[goneAt(id)] >> (id & 31u) & 1u) != 0u;
}

// The hit in place of one that is gone, or VCT_HIT_UNKNOWN.
uint hitInstead(uint hit) {
    uint instead = faceInstead((hit & ~VCT_HIT_NEAR) - VCT_HIT_FACE);
    return instead == 0u ? VCT_HIT_UNKNOWN : VCT_HIT_FACE + instead - 1u | hit & VCT_HIT_NEAR;
}

void main() {
    const uint size = uint(VCT_LIST_GROUP);
    uint count = faceCount(0u), groups = (count + size - 1u) / size;
    uint parts = (groups + VCT_FORWARD_TURNS - 1u) / VCT_FORWARD_TURNS * turns;
    for (uint i = gl_WorkGroupID.x; i < parts; i += gl_NumWorkGroups.x) {
        uint turn = (lightStep.frame + i % turns) % VCT_FORWARD_TURNS;
        uint id = (i / turns * VCT_FORWARD_TURNS + turn) * size + gl_LocalInvocationIndex;
        if (id >= count) continue;
        ListedFace listed = baseFace(id);
        // A ray does not meet cascades that are finer than that of its face. New faces have no hits.
        if (listed.isMerged || cascadeOf(listed.voxel) > findMSB(moved) || isFresh(id)) continue;
        uint lost = 0u;
        for (uint quad = 0u; quad < uint(VCT_DIRECTIONS) / 4u; ++quad) {
            uvec4 hits = cachedHits(id, quad);
            bvec4 gone = bvec4(isLost(hits.x), isLost(hits.y), isLost(hits.z), isLost(hits.w));
            if (!any(gone)) continue;
            for (int i = 0; i < 4; ++i) {
                if (!gone[i]) continue;
                hits[i] = hitInstead(hits[i]);
                lost += uint(hits[i] == VCT_HIT_UNKNOWN);
            }
            storeCachedHits(id, quad, hits);
        }
        if (lost == 0u) continue;
        storeChangedNow(id);
        // Hits that are lost were of faces. The sky's share of the mean grows, as that of the other
        // rays.
        FaceSight sight = faceSight(id);
        uint known = sight.rays - min(lost, sight.rays);
        vec4 sky = faceMean(id, VCT_MEAN_SKY) * (known == 0u ? 0.0 : float(sight.rays) / float(known));
        storeFaceMean(id, VCT_MEAN_SKY, sky);
        storeFaceSight(id, FaceSight(sight.nearness, sight.backs, known));
    }
}
