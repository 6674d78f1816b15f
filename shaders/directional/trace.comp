// Traces cached rays of static faces that have hit nothing yet, a few per face and step. They meet static
// geometry, so that their hits stay (directional/block_rays.comp finds the moving objects before them). Where
// a moving object has the same plane, some of all rays are traced again in each step.
#include "directional/trace_rays.glsl"
#include "directional/visited.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// Makes all rays of a face unknown.
void invalidateRays(uint id) {
    for (uint quad = 0u; quad < uint(VCT_DIRECTIONS) / 4u; ++quad)
        storeCachedHits(id, quad, uvec4(VCT_HIT_UNKNOWN));
    storeFaceSight(id, FaceSight(0.0, 0u, 0u));
    storeFaceMean(id, VCT_MEAN_SKY, vec4(0.0));
}

// The number of a static face's unknown rays that this step may trace. Faces that cascades have reached with
// a move are many, and show the light of a coarser cascade meanwhile.
uint raysInStep(uint id) {
#if VCT_CASCADES > 1
    if (visitsAll == 0u && hasChangedSince(id, lightStep.visitsSince - 1u))
        return max(lightStep.rays / VCT_MOVE_PACE, 1u);
#endif
    return lightStep.rays;
}

// True if a static face has the plane of a moving object as well.
bool isMergedNow(ListedFace listed) {
    return hasFace(dynamicCellAt(listed.voxel), listed.face);
}

void main() {
    uint count = visitedFaceCount();
    for (uint i = gl_GlobalInvocationID.x; i < count; i += gl_NumWorkGroups.x * uint(VCT_LIST_GROUP)) {
        uint id = visitedFaceId(i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged || id >= commands[0].faceCapacity) continue;
        uint blocked = irradianceAt(id) + VCT_FACE_BLOCKED + 1u;
        bool merged = isMergedNow(listed);
        if (merged != ((faceIrradianceData[blocked] & wasMerged) != 0u)) {
            invalidateRays(id);
            storeBlockedCounts(id, 0u, 0u, merged);
        }
        // Baked light comes with a sight, and without hits.
        if (!merged && cachedHit(id, 0u) == VCT_HIT_UNKNOWN) storeFaceSight(id, FaceSight(0.0, 0u, 0u));
        FaceSight sight = faceSight(id);
        uint unknown = uint(VCT_DIRECTIONS) - min(sight.rays + sight.backs, uint(VCT_DIRECTIONS));
        uint again = movingRaysOfFace(), number = merged ? again : min(raysInStep(id), unknown);
        if (number == 0u) continue;
        uint geometry = backsOfFaces | (merged ? allGeometry : staticGeometry);
        // The rays of a static face become known in this order, unless it has lost some.
        uint d = merged ? lightStep.frame * again : uint(VCT_DIRECTIONS) - unknown;
        for (uint n = 0u; n < uint(VCT_DIRECTIONS) && number > 0u; ++n, ++d) {
            d %= uint(VCT_DIRECTIONS);
            if (!merged && cachedHit(id, d) != VCT_HIT_UNKNOWN) continue;
            TracedRays traced = TracedRays(vec4(0.0), 0.0, ivec3(0));
            traceCached(raysOf(listed, id), id, d, geometry, traced);
            updateMeans(id, traced);
            --number;
        }
    }
}
