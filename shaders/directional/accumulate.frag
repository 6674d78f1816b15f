// Second of two passes over the triangles. Each fragment adds its coverage, place, albedo, emission and plane
// to the sums of the voxel's faces that it covers. The sums are integers, so the order of the fragments does
// not matter.
#include "directional/coverage.glsl"
#include "directional/face_sums.glsl"
#include "directional/index.glsl"

centroid in vec3 fragmentNormal;

layout(location = VCT_UNIFORM_LIST) uniform uint list;

void main() {
    Samples samples = fragmentSamples();
    vec4 baseColor = materialBaseColor();
    if (materialIsHole(baseColor.a)) discard;
    vec3 albedo = materialIsUnlit ? vec3(0.0) : clamp(baseColor.rgb, 0.0, 1.0);
    vec3 emission = materialEmissive() * (draw.surface.w / frame.emissionRange);
    vec3 normal = safeNormalize(fragmentNormal);
    while (samples.left != 0u) {
        Part part = nextPart(samples);
        vec3 coverage = part.coverage;
        if (isKept(part.voxel)) continue;
        ivec3 voxel = listedVoxel(part.voxel);
        uint cell = list == 0u ? staticCellAt(voxel) : cellInPages(dynamicIndex, dynamicPages, voxel);
        bool curved = dot(normal, safeNormalize(coverage)) < 0.9999;  // 0.8 degrees
        vec3 place = part.place - vec3(part.voxel);
        vec3 fromMiddle = place - 0.5;
        float offset = dot(normal, fromMiddle), nearness = max(1.0 - 0.6 * length(fromMiddle), 0.0);
        uint fronts = coveredFaces(coverage), backs = materialIsDoubleSided ? coveredFaces(-coverage) : 0u;
        // A loop over set bits, because most surfaces cover one face only. The cell is 0 if the list has no
        // room for the voxel; a later frame has room.
        for (uint left = (fronts | backs) & cell; left != 0u; left &= left - 1u) {
            int face = findLSB(left);
            uint at = sumsAt(faceId(cell, face));
            float side = (fronts >> uint(face) & 1u) != 0u ? 1.0 : -1.0, weight = abs(coverage[face >> 1]);
            float front = 0.5 + ((face & 1) == 0 ? fromMiddle[face >> 1] : -fromMiddle[face >> 1]);
            // Two surfaces may have the face. The one that looks towards it counts.
            float key = nearness * (0.4 + 0.6 * abs(normal[face >> 1]));
            atomicMax(faceSumData[at + VCT_FACE_PLANE], packPlane(key, curved, side * normal, side * offset));
            atomicMax(faceSumData[at + VCT_FACE_FRONT],
                      packPlane(clamp(front, 0.0, 1.0), curved, side * normal, side * offset));
            atomicMax(faceSumData[at + VCT_FACE_FRONT_ALBEDO],
                      packFrontAlbedo(clamp(front, 0.0, 1.0), albedo));
            addToWords(at + VCT_FACE_ALBEDO, weight * albedo);
            uvec3 units =
                uvec3(vec3(weight, weight * acrossFaces(place, face >> 1)) * frame.faceSumUnits + 0.5);
            atomicAdd(faceSumData[at + VCT_FACE_COVERAGE], units.x);
            atomicAdd(faceSumData[at + VCT_FACE_PLACE], units.y);
            atomicAdd(faceSumData[at + VCT_FACE_PLACE + 1u], units.z);
            if (curved) {
                vec2 across = 0.5 + 0.5 * side * acrossFaces(normal, face >> 1);
                atomicAdd(faceSumData[at + VCT_FACE_CURVE], units.x);
                addToWords(at + VCT_FACE_CURVE + 1u, weight * vec3(across, place[face >> 1]));
            }
#ifdef VCT_EMISSION
            addToWords(at + VCT_FACE_EMISSION, weight * emission);
#endif
        }
    }
}
