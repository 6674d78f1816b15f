// After cascades have moved, lets the cached rays of static faces whose hits are gone hit the faces of the
// next cascade in their place. Rays for which there is none are unknown, and so are all rays of new faces.
// Only with cascades.
#include "directional/face_lists.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_CASCADES) uniform uint moved;  // a bit per cascade

// The hit now, or VCT_HIT_UNKNOWN.
uint hitNow(uint hit, bool isNew) {
    uint code = hit & ~VCT_HIT_NEAR;
    if (isNew) return VCT_HIT_UNKNOWN;
    if (code < VCT_HIT_FACE || !isGone(code - VCT_HIT_FACE)) return hit;
    uint instead = faceInstead(code - VCT_HIT_FACE);
    return instead == 0u ? VCT_HIT_UNKNOWN : VCT_HIT_FACE + instead - 1u | hit & VCT_HIT_NEAR;
}

uint unknownOf(uvec4 hits) {
    return uint(hits.x == VCT_HIT_UNKNOWN) + uint(hits.y == VCT_HIT_UNKNOWN) +
           uint(hits.z == VCT_HIT_UNKNOWN) + uint(hits.w == VCT_HIT_UNKNOWN);
}

void main() {
    uint count = faceCount(0u);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint id = gl_GlobalInvocationID.x; id < count; id += stride) {
        ListedFace listed = baseFace(id);
        // A ray does not meet cascades that are finer than that of its face.
        if (listed.isMerged || cascadeOf(listed.voxel) > findMSB(moved)) continue;
        bool isNew = isFresh(id);
        uint lost = 0u;
        for (uint quad = 0u; quad < uint(VCT_DIRECTIONS) / 4u; ++quad) {
            uvec4 hits = cachedHits(id, quad);
            uvec4 now = uvec4(hitNow(hits.x, isNew), hitNow(hits.y, isNew), hitNow(hits.z, isNew),
                              hitNow(hits.w, isNew));
            if (hits == now) continue;
            storeCachedHits(id, quad, now);
            lost += unknownOf(now) - unknownOf(hits);
        }
        if (lost == 0u && !isNew) continue;
        faceIrradianceData[changedAt(id)] = lightStep.frame + 1u;
        // Hits that are lost were of faces. The sky's share of the mean grows, as that of the other
        // rays.
        FaceSight sight = faceSight(id);
        uint known = isNew ? 0u : sight.rays - min(lost, sight.rays);
        vec4 sky = faceMean(id, VCT_MEAN_SKY) * (known == 0u ? 0.0 : float(sight.rays) / float(known));
        storeFaceMean(id, VCT_MEAN_SKY, sky);
        storeFaceMean(id, VCT_MEAN_SKY_NOW, sky);
        storeFaceSight(id, FaceSight(sight.nearness, isNew ? 0u : sight.backs, known));
    }
}
