// The irradiance of each face now: the mean over the radiance of what its cached rays hit, and of the moving
// objects that block some of them.
#include "directional/visited.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// The sum of the radiance of the faces that four rays have hit; 0 for those that have hit none. Vectors over
// the rays cost half of the instructions that a vector of colours for each ray does. Bits are cut out by
// shifts, for the reason in directional/face_words.glsl. `firstWord`: allBlockWords().
vec3 radianceOf(uvec4 hits, uint firstWord) {
    uvec4 codes = hits << codeShift >> codeShift;
    // A face is read in any case, because a selection is cheaper than a branch.
    uvec4 ids = max(codes, uvec4(VCT_HIT_FACE)) - VCT_HIT_FACE;
    uvec4 at = firstWord + (ids >> 6u) * (VCT_FACE_GROUP * faceWords) + ids;  // faceRadianceWord()
    uvec4 words = uvec4(faceData[at.x], faceData[at.y], faceData[at.z], faceData[at.w]);
    vec4 scale = scaleOfRgb9e5(words) * vec4(greaterThanEqual(codes, uvec4(VCT_HIT_FACE)));
    return vec3(dot(vec4(words << 23u >> 23u), scale), dot(vec4(words << 14u >> 23u), scale),
                dot(vec4(words << 5u >> 23u), scale));
}

void main() {
    uint count = visitedFaceCount(), firstWord = allBlockWords();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(i);
        vec3 light = vec3(0.0);
        uint hits = hitsAt(id, 0u);
        for (uint octet = 0u; octet < uint(VCT_DIRECTIONS) / 8u; ++octet) {
            light += radianceOf(cachedHitsFrom(hits, 0u), firstWord);
            light += radianceOf(cachedHitsFrom(hits, 1u), firstWord);
            hits += hitsStep;
        }
        uint first = firstBlockedOf(id);
        uint blocked = faceIrradianceData[irradianceAt(id) + VCT_FACE_BLOCKED + 1u] & 0xFFu;
        for (uint b = 0u; b < blocked; ++b) {
            uint word = faceIrradianceData[first + b];
            uvec4 now = uvec4(word & 0xFFFFFFu, uvec3(VCT_HIT_SKY));
            uvec4 before = uvec4(cachedHit(id, word >> 24u), uvec3(VCT_HIT_SKY));
            light += radianceOf(now, firstWord) - radianceOf(before, firstWord);
        }
        light = max(light, 0.0) / max(float(countedRays(id)), 1.0);
        vec4 sky = meanFrom(blocked > 0u ? first + blocked : irradianceAt(id) + VCT_MEAN_SKY);
        storeFaceMean(id, VCT_MEAN_NOW, vec4(light, 0.0) + sky);
    }
}
