// The sums of each base-level face: geometry and material of the fragments that cover it, in fixed point. One
// unit is 1 / frame.faceSumUnits, chosen so that a sum over all triangles of the scene fits into 32 bits, as
// a triangle covers a face at most once. VCT_EMISSION: surfaces emit light, so faces also have sums of
// emission.
#include "shared/frame.glsl"
#include "shared/normals.glsl"
#include "directional/face_lists.glsl"

#define VCT_FACE_SURFACE 0u  // packSurface(), written by the injection of light
#define VCT_FACE_PLANE 1u    // packPlane() of the fragment that covers most; not a sum
#define VCT_FACE_COVERAGE 2u
#define VCT_FACE_ALBEDO 3u    // three words, weighted by coverage
#define VCT_FACE_EMISSION 6u  // three words, weighted by coverage, relative to frame.emissionRange

// Radiance and coverage of the face's texel before its cascade moved, as packUnorm4x8() packs them. Only in
// the list before the move, where no pass reads the sums of such a cascade.
#define VCT_FACE_LAST_RADIANCE VCT_FACE_COVERAGE

#ifdef VCT_EMISSION
const uint faceWords = VCT_EMISSIVE_FACE_WORDS;
#else
const uint faceWords = VCT_FACE_WORDS;
#endif

// The plane of the surface in a voxel: its normal, and its distance from the voxel's middle along the normal,
// in voxels, at most half the diagonal. Here and everywhere bits are masked one component at a time, because
// some Mali drivers compute "vector & constant" wrongly (Dolphin, DriverDetails.h,
// BUG_BROKEN_VECTOR_BITWISE_AND).
struct SurfacePlane {
    vec3 normal;
    float offset;
};

// The coverage is in the highest bits, so that atomicMax() keeps the plane of the fragment that covers most.
// `isCurved`: the normals differ from the triangle's, as on a round surface made of flat triangles.
uint packPlane(float coverage, bool isCurved, vec3 normal, float offset) {
    uvec2 steps = uvec2(vec2(coverage, clamp(offset, -1.0, 1.0) * 0.5 + 0.5) * vec2(127.0, 255.0) + 0.5);
    uvec2 code = (encodeOctahedral(normal) * 127u + 16383u) / 32767u;  // 254 steps: even, so 0 is exact
    return (steps.x << 25) | (isCurved ? 1u << 24 : 0u) | (steps.y << 16) | (code.x << 8) | code.y;
}
bool isCurved(uint plane) {
    return (plane & 1u << 24) != 0u;
}
SurfacePlane unpackPlane(uint word) {
    uvec3 steps = uvec3(word >> 16 & 255u, word >> 8 & 255u, word & 255u);
    return SurfacePlane(decodeOctahedral(steps.yz, 254.0), float(steps.x) / 127.5 - 1.0);
}

// Converts coverage in 0..1 to fixed point. If the result is 0, the fragment must not add to the face.
uint fixedCoverage(float weight) {
    return uint(weight * frame.faceSumUnits + 0.5);
}

void addToWords(uint at, vec3 value) {
    uvec3 units = uvec3(clamp(value, 0.0, 1.0) * frame.faceSumUnits + 0.5);
    if (units.x != 0u) atomicAdd(faceData[at], units.x);
    if (units.y != 0u) atomicAdd(faceData[at + 1u], units.y);
    if (units.z != 0u) atomicAdd(faceData[at + 2u], units.z);
}

// Adds a fragment to a face's sums. `weight`: its coverage, 0..1. `emission`: relative to
// frame.emissionRange.
void addToFace(uint id, float weight, vec3 albedo, vec3 emission, bool curved, vec3 normal, float offset) {
    uint at = id * faceWords;
    atomicMax(faceData[at + VCT_FACE_PLANE], packPlane(weight, curved, normal, offset));
    atomicAdd(faceData[at + VCT_FACE_COVERAGE], fixedCoverage(weight));
    addToWords(at + VCT_FACE_ALBEDO, weight * clamp(albedo, 0.0, 1.0));
#ifdef VCT_EMISSION
    addToWords(at + VCT_FACE_EMISSION, weight * emission);
#endif
}

struct FaceSums {
    float coverage;  // more than 1 if the voxel has several layers of surface
    vec3 albedo;     // weighted by coverage
    vec3 emission;   // weighted by coverage, relative to E/pi
    uint plane;
};

vec3 threeWords(uint at) {
    return vec3(uvec3(faceData[at], faceData[at + 1u], faceData[at + 2u])) / frame.faceSumUnits;
}

FaceSums faceSums(uint id) {
    uint at = id * faceWords;
    float coverage = float(faceData[at + VCT_FACE_COVERAGE]) / frame.faceSumUnits;
    vec3 emission = vec3(0.0);
#ifdef VCT_EMISSION
    emission = threeWords(at + VCT_FACE_EMISSION) * frame.emissionRange;
#endif
    return FaceSums(coverage, threeWords(at + VCT_FACE_ALBEDO), emission, faceData[at + VCT_FACE_PLANE]);
}

FaceSums combine(FaceSums a, FaceSums b) {
    return FaceSums(a.coverage + b.coverage, a.albedo + b.albedo, a.emission + b.emission,
                    max(a.plane, b.plane));
}

// The sums of a face in the static and the dynamic index, added together.
FaceSums combinedSums(uint staticCell, uint dynamicCell, int face) {
    FaceSums sums = FaceSums(0.0, vec3(0.0), vec3(0.0), 0u);
    uint id;
    if (findStaticFace(staticCell, face, id)) sums = faceSums(id);
    return findDynamicFace(dynamicCell, face, id) ? combine(sums, faceSums(id)) : sums;
}

// The data of a face that the gather and the look-ups need, for static and dynamic geometry together.
struct FaceSurface {
    SurfacePlane plane;
    float coverage;  // 0..1
    bool hasBack;    // the surface is one side of a sheet or a thin plate
};

uint packSurface(uint plane, float coverage, bool hasBack) {
    return (hasBack ? 0x80000000u : 0u) | uint(min(coverage, 1.0) * 127.0 + 0.5) << 24 | (plane & 0xFFFFFFu);
}
FaceSurface faceSurface(uint id) {
    uint word = faceData[id * faceWords + VCT_FACE_SURFACE];
    return FaceSurface(unpackPlane(word), float(word >> 24 & 127u) / 127.0, (word & 0x80000000u) != 0u);
}
