// Traces cached rays of a face, and updates its means over them.
#include "directional/face_rays.glsl"

// TracedRays is what some rays of a face change in its means.
struct TracedRays {
    vec4 sky;        // the sum of skyOf()
    float nearness;  // the sum of 1 / distance over the rays that count now
    ivec3 count;     // x: of the rays that count in the mean; y: of those that meet a back; z: of those that
                     // count now
};

// Traces a cached ray, whose hit takes the place of the one before.
void traceCached(FaceRays rays, uint id, uint d, uint geometry, inout TracedRays traced) {
    int number = cachedDirection(rays, d);
    vec3 aroundNormal = gatherDirection(number), towards = rays.axes * aroundNormal;
    float distance;
    uint hit = traceFrom(rays, towards, rays.reach, number, geometry, distance);
    uvec4 hits = cachedHits(id, d >> 2u);
    uint before = hits[d & 3u];
    hits[d & 3u] = hit;
    storeCachedHits(id, d >> 2u, hits);
    vec3 sky = skyAlong(towards, aroundNormal);
    if (countsInMean(before)) {
        traced.sky -= skyOf(before, sky);
        --traced.count.x;
    } else if (before != VCT_HIT_UNKNOWN) {
        --traced.count.y;
    }
    if (countsInMean(hit)) {
        traced.sky += skyOf(hit, sky);
        traced.nearness += (hit & ~VCT_HIT_NEAR) >= VCT_HIT_FACE ? 1.0 / max(distance, 0.5) : 0.0;
        traced.count += ivec3(1, 0, 1);
    } else {
        ++traced.count.y;
    }
}

void updateMeans(uint id, TracedRays traced) {
    FaceSight sight = faceSight(id);
    vec4 sum = faceMean(id, VCT_MEAN_SKY) * float(sight.rays) + traced.sky;
    sight.rays = uint(int(sight.rays) + traced.count.x);
    sight.backs = uint(int(sight.backs) + traced.count.y);
    vec4 mean = max(sum, 0.0) / max(float(sight.rays), 1.0);
    storeFaceMean(id, VCT_MEAN_SKY, mean);
    if (traced.count.z > 0) {
        float now = float(traced.count.z);
        sight.nearness = mix(sight.nearness, traced.nearness / now, now / float(sight.rays));
    }
    storeFaceSight(id, sight);
}

// The number of rays that a face traces again in this step because objects move.
uint movingRaysOfFace() {
    return clamp(lightStep.movingRays / max(faceCount(dynamicList), 1u), lightStep.minMovingRays,
                 uint(VCT_DIRECTIONS));
}
