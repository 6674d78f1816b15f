// Second of two passes over the triangles. Each fragment adds its coverage, albedo, emission and plane to
// the sums of the voxel's faces that it covers. The sums are integers, so the order of the fragments does not
// matter.
#include "shared/counters.glsl"
#include "directional/coverage.glsl"

in vec3 fragmentNormal;

layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D index;  // the index of the faces in `list`
layout(location = VCT_UNIFORM_LIST) uniform uint list;

void main() {
    COUNT(VCT_COUNTER_ACCUMULATE);
    vec3 coverage = fragmentCoverage();
    vec4 baseColor = materialBaseColor();
    if (materialIsHole(baseColor.a)) discard;
    ivec3 voxel = fragmentVoxel();
    uint cell = texelFetch(index, listedVoxel(voxel), 0).r;
    vec3 albedo = materialIsUnlit ? vec3(0.0) : baseColor.rgb;
    vec3 emission = materialEmissive() * (draw.surface.w / frame.emissionRange);
    vec3 normal = safeNormalize(fragmentNormal);
    bool curved = dot(normal, safeNormalize(coverage)) < 0.9999;  // 0.8 degrees
    float offset = dot(normal, fragmentPosition * float(frame.gridSide) - vec3(voxel) - 0.5);
    uint firstId = commands[list].firstId, lastId = firstId + commands[list].faceCapacity;
    uint front = coveredFaces(coverage), back = materialIsDoubleSided ? coveredFaces(-coverage) : 0u;
    // A loop over set bits, because most surfaces cover one face only.
    for (uint left = (front | back) & cell; left != 0u; left &= left - 1u) {
        COUNT(VCT_COUNTER_ACCUMULATE_FACE);
        int face = findLSB(left);
        uint id = faceId(cell, face, firstId);
        if (!hasFace(cell, face) || id >= lastId) break;  // the list overflowed; a later frame has room
        float side = (front >> uint(face) & 1u) != 0u ? 1.0 : -1.0;
        addToFace(id, abs(coverage[face >> 1]), albedo, emission, curved, side * normal, side * offset);
    }
}
