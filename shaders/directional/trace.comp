// Traces cached rays: those that have hit nothing yet, a few per face and step, and of moving objects' faces
// some of all rays again. Rays of static faces meet static geometry, so that their hits stay
// (directional/block_rays.comp finds the moving objects before them).
#include "directional/face_rays.glsl"
#include "directional/visited.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// Traces a cached ray of a face, and replaces what it has hit before in the means over the rays.
void traceCached(uint id, uint d, uint geometry) {
    FaceRays rays = raysOf(baseFace(id), id);
    int number = cachedDirection(rays, d);
    vec3 aroundNormal = gatherDirection(number), towards = rays.axes * aroundNormal;
    vec3 sky = skyAlong(towards, aroundNormal);
    float distance;
    uint hit = traceFrom(rays, towards, rays.reach, number, geometry, distance);
    uvec4 hits = cachedHits(id, d >> 2u);
    uint before = hits[d & 3u];
    hits[d & 3u] = hit;
    storeCachedHits(id, d >> 2u, hits);
    FaceSight sight = faceSight(id);
    bool countedBefore = countsInMean(before), countsNow = countsInMean(hit);
    vec4 sum = faceMean(id, VCT_MEAN_SKY) * float(sight.rays) + (countsNow ? skyOf(hit, sky) : vec4(0.0)) -
               (countedBefore ? skyOf(before, sky) : vec4(0.0));
    if (before != VCT_HIT_UNKNOWN && !countedBefore) --sight.backs;
    if (!countsNow) ++sight.backs;
    sight.rays += uint(countsNow) - uint(countedBefore);
    vec4 mean = max(sum, 0.0) / max(float(sight.rays), 1.0);
    storeFaceMean(id, VCT_MEAN_SKY, mean);
    storeFaceMean(id, VCT_MEAN_SKY_NOW, mean);
    if (countsNow) {
        float nearness = (hit & ~VCT_HIT_NEAR) >= VCT_HIT_FACE ? 1.0 / max(distance, 0.5) : 0.0;
        sight.nearness = mix(sight.nearness, nearness, 1.0 / float(sight.rays));
    }
    storeFaceSight(id, sight);
}

// Makes all rays of a face unknown.
void invalidateRays(uint id) {
    for (uint quad = 0u; quad < uint(VCT_DIRECTIONS) / 4u; ++quad)
        storeCachedHits(id, quad, uvec4(VCT_HIT_UNKNOWN));
    storeFaceSight(id, FaceSight(0.0, 0u, 0u));
    storeFaceMean(id, VCT_MEAN_SKY, vec4(0.0));
}

// True if a static face has the plane of a moving object as well.
bool isMergedNow(ListedFace listed) {
    return frame.hasDynamicObjects != 0 && hasFace(texelFetch(dynamicIndex, listed.voxel, 0).r, listed.face);
}

void main() {
    uint count = visitedFaceCount(), dynamicCount = faceCount(dynamicList);
    uint again =
        clamp(lightStep.movingRays / max(dynamicCount, 1u), lightStep.minMovingRays, uint(VCT_DIRECTIONS));
    for (uint i = gl_GlobalInvocationID.x; i < count; i += gl_NumWorkGroups.x * uint(VCT_LIST_GROUP)) {
        uint id = visitedFaceId(i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged) continue;
        bool isDynamic = id >= commands[0].faceCapacity;  // static faces have the first ids
        uint blocked = irradianceAt(id) + VCT_FACE_BLOCKED + 1u;
        bool merged = !isDynamic && isMergedNow(listed);
        if (!isDynamic && merged != ((faceIrradianceData[blocked] & wasMerged) != 0u)) {
            invalidateRays(id);
            storeBlockedCounts(id, 0u, 0u, merged);
        }
        isDynamic = isDynamic || merged;
        // Baked light comes with a sight, and without hits.
        if (!isDynamic && cachedHit(id, 0u) == VCT_HIT_UNKNOWN) storeFaceSight(id, FaceSight(0.0, 0u, 0u));
        FaceSight sight = faceSight(id);
        uint unknown = uint(VCT_DIRECTIONS) - min(sight.rays + sight.backs, uint(VCT_DIRECTIONS));
        uint number = isDynamic ? again : min(lightStep.rays, unknown);
        if (number == 0u) continue;
        uint geometry = backsOfFaces | (isDynamic ? allGeometry : staticGeometry);
        // The rays of a static face become known in this order, unless it has lost some.
        uint d = isDynamic ? lightStep.frame * again : uint(VCT_DIRECTIONS) - unknown;
        for (uint n = 0u; n < uint(VCT_DIRECTIONS) && number > 0u; ++n, ++d) {
            d %= uint(VCT_DIRECTIONS);
            if (!isDynamic && cachedHit(id, d) != VCT_HIT_UNKNOWN) continue;
            traceCached(id, d, geometry);
            --number;
        }
    }
}
