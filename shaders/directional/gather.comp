// The irradiance of each face now: the mean over the radiance of what its cached rays hit, and of the moving
// objects that block some of them.
#include "directional/visited.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// The radiance of the face that a ray has hit; 0 if it has hit none.
vec3 radianceOf(uint hit) {
    uint code = hit & ~VCT_HIT_NEAR;
    // The face is read in any case, because a selection is cheaper than a branch.
    vec3 radiance = faceRadiance(max(code, VCT_HIT_FACE) - VCT_HIT_FACE);
    return code >= VCT_HIT_FACE ? radiance : vec3(0.0);
}

void main() {
    uint count = visitedFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(i);
        vec3 light = vec3(0.0);
        for (uint quad = 0u; quad < uint(VCT_DIRECTIONS) / 4u; ++quad) {
            uvec4 hits = cachedHits(id, quad);
            light += radianceOf(hits.x) + radianceOf(hits.y) + radianceOf(hits.z) + radianceOf(hits.w);
        }
        uint at = irradianceAt(id) + VCT_FACE_BLOCKED, first = faceIrradianceData[at];
        uint blocked = faceIrradianceData[at + 1u] & 0xFFFFu;
        for (uint b = 0u; b < blocked; ++b) {
            uint word = faceIrradianceData[first + b];
            light += radianceOf(word & 0xFFFFFFu) - radianceOf(cachedHit(id, word >> 24u));
        }
        light = max(light, 0.0) / max(float(countedRays(id)), 1.0);
        storeFaceMean(id, VCT_MEAN_NOW, vec4(light, 0.0) + faceMean(id, VCT_MEAN_SKY_NOW));
    }
}
