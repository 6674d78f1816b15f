// What the fragments of each occupied voxel add up to, per face, in fixed point. One unit is 1 / frame.faceSumUnits, chosen
// so that the sum over all triangles of the scene fits 32 bits: the fragments of a triangle in a voxel are one face at
// most together. Behind the sums: directional/face_list.glsl.
#include "shared/frame.glsl"
#include "shared/octahedral.glsl"

layout(std430, binding = VCT_SSBO_FACE_SUMS) buffer FaceSumBlock {
    uint faceSums[];  // per slot: marks, then per face VCT_FACE_SUM_*
};

#define VCT_FACE_SUM_COVERAGE 0u
#define VCT_FACE_SUM_RADIANCE 1u  // three, relative to E/pi over frame.radianceRange
#define VCT_FACE_SUM_ALBEDO 4u    // no sum: that of the fragment that covers most, packAlbedo()
#define VCT_FACE_SUM_PLANE 5u     // likewise, packPlane()

uint slotIndex(uint slot) {
    return slot * VCT_SLOT_WORDS;
}

uint faceSumIndex(uint slot, int face) {
    return slotIndex(slot) + 1u + uint(face) * VCT_FACE_SUM_WORDS;
}

// Coverage above, so that the maximum is of what covers most; roots, as in the G-buffer.
uint packAlbedo(float coverage, vec3 albedo) {
    uvec4 steps = uvec4(vec4(coverage, sqrt(albedo)) * 255.0 + 0.5);
    return (steps.x << 24) | (steps.y << 16) | (steps.z << 8) | steps.w;
}

// Bits are masked one component at a time, here and everywhere: of a vector and a constant some drivers for Mali give the
// constant (Dolphin, DriverDetails.h, BUG_BROKEN_VECTOR_BITWISE_AND). Albedo would be white.
vec3 unpackAlbedo(uint word) {
    vec3 root = vec3(word >> 16 & 255u, word >> 8 & 255u, word & 255u) / 255.0;
    return root * root;
}

// The plane of the surface in a voxel: its normal, and how far in front of the voxel's middle it lies, along the normal in
// voxels, at most half the diagonal. Coverage above, as in packAlbedo().
uint packPlane(float coverage, vec3 normal, float offset) {
    uvec2 steps = uvec2(vec2(coverage, clamp(offset, -1.0, 1.0) * 0.5 + 0.5) * 255.0 + 0.5);
    uvec2 code = (encodeNormal(normal) * 127u + 16383u) / 32767u;  // 254 steps: even, so 0 is exact
    return (steps.x << 24) | (steps.y << 16) | (code.x << 8) | code.y;
}

struct SurfacePlane {
    vec3 normal;
    float offset;
};

SurfacePlane unpackPlane(uint word) {
    uvec3 steps = uvec3(word >> 16 & 255u, word >> 8 & 255u, word & 255u);
    return SurfacePlane(decodeNormal(steps.yz * 32767u / 127u), float(steps.x) / 127.5 - 1.0);
}

// A face's share of its voxel's cross-section, in 0..1, in fixed point. Where it is 0 nothing may be added.
uint fixedCoverage(float weight) {
    return uint(weight * frame.faceSumUnits + 0.5);
}

// `weight` in 0..1.
void addSurface(uint slot, int face, float weight, vec3 albedo, vec3 normal, float offset) {
    uint index = faceSumIndex(slot, face);
    atomicAdd(faceSums[index + VCT_FACE_SUM_COVERAGE], fixedCoverage(weight));
    atomicMax(faceSums[index + VCT_FACE_SUM_ALBEDO], packAlbedo(weight, clamp(albedo, 0.0, 1.0)));
    atomicMax(faceSums[index + VCT_FACE_SUM_PLANE], packPlane(weight, normal, offset));
}

// Likewise; `radiance` relative to E/pi.
void addRadiance(uint slot, int face, float weight, vec3 radiance) {
    uvec3 units = uvec3(clamp(weight / frame.radianceRange * radiance, 0.0, 1.0) * frame.faceSumUnits + 0.5);
    if (units == uvec3(0u)) return;
    uint index = faceSumIndex(slot, face);
    atomicAdd(faceSums[index + VCT_FACE_SUM_RADIANCE], units.x);
    atomicAdd(faceSums[index + VCT_FACE_SUM_RADIANCE + 1u], units.y);
    atomicAdd(faceSums[index + VCT_FACE_SUM_RADIANCE + 2u], units.z);
}

// `faces`: bits. To be called for those that something was added to.
void markFaces(uint slot, uint faces) {
    atomicOr(faceSums[slotIndex(slot)], faces);
}

// A bit for each face that is not empty.
uint markedFaces(uint slot) {
    return faceSums[slotIndex(slot)] & VCT_FACE_MASK;
}

// And above them, for each that the static geometry fills where something else moves: those stay listed.
uint staticFaces(uint slot) {
    return faceSums[slotIndex(slot)] >> VCT_FACE_MASK_BITS & VCT_FACE_MASK;
}
void setMarks(uint slot, uint marked, uint still) {
    uint glowing = marked << (2 * VCT_FACE_MASK_BITS) & faceSums[slotIndex(slot)];
    faceSums[slotIndex(slot)] = marked | (still << VCT_FACE_MASK_BITS) | glowing;
}

// And above those, for each that something which emits is in.
void markGlowing(uint slot, uint faces) {
    atomicOr(faceSums[slotIndex(slot)], faces << (2 * VCT_FACE_MASK_BITS));
}
bool isGlowing(uint slot, int face) {
    return (faceSums[slotIndex(slot)] >> (2 * VCT_FACE_MASK_BITS + face) & 1u) != 0u;
}

float faceCoverage(uint slot, int face) {
    return min(float(faceSums[faceSumIndex(slot, face) + VCT_FACE_SUM_COVERAGE]) / frame.faceSumUnits, 1.0);
}

SurfacePlane facePlane(uint slot, int face) {
    return unpackPlane(faceSums[faceSumIndex(slot, face) + VCT_FACE_SUM_PLANE]);
}

// Whether the face's surface, of that plane, is one side of a sheet or a thin plate. (Two walls of an edge look to opposite sides
// too, but not against each other.)
bool hasBack(uint slot, int face, SurfacePlane plane) {
    return faceCoverage(slot, face ^ 1) > 0.5 * faceCoverage(slot, face) &&
           dot(facePlane(slot, face ^ 1).normal, plane.normal) < -0.8;
}

// A face's share of the voxel's cross-section, and premultiplied by it radiance and albedo. More than one layer of
// surface in a voxel: it is covered, and shines with their mean; but where one of them emits, with their sum, as a lamp that
// hangs right under a ceiling is in front of it, and sends what it sends.
//
// A slanted surface stands in up to three faces. Together they cover what it covers to rays against its normal, but to rays
// from other sides, and from behind, more: they would send up to 1.7 times its light. Scaled by the normal's component they
// would send as much as it does, but be too dark from the front, as in a closed slanted room. The cube root lies between
// the two errors (docs/levers.md, "Slanted surfaces").
struct FaceSum {
    float coverage;
    vec3 radiance;  // relative to E/pi over frame.radianceRange
    vec3 albedo;
};

// Of a face that is not empty.
FaceSum faceSum(uint slot, int face) {
    uint index = faceSumIndex(slot, face);
    float sum = float(faceSums[index + VCT_FACE_SUM_COVERAGE]);
    float scale = 1.0 / max(sum, frame.faceSumUnits);
    uint at = index + VCT_FACE_SUM_RADIANCE;
    vec3 radiance = vec3(uvec3(faceSums[at], faceSums[at + 1u], faceSums[at + 2u]));
    radiance *= isGlowing(slot, face) ? 1.0 / frame.faceSumUnits : scale;
    vec3 albedo = unpackAlbedo(faceSums[index + VCT_FACE_SUM_ALBEDO]) * (sum * scale);
    float shining = pow(abs(facePlane(slot, face).normal[face >> 1]), 1.0 / 3.0);
    return FaceSum(sum * scale, shining * radiance, shining * albedo);
}
