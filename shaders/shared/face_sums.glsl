// What the fragments of each occupied voxel add up to, per face, in fixed point. One unit is 1 / frame.faces.x, chosen
// so that the sum over all triangles of the scene fits 32 bits: the fragments of a triangle in a voxel are one face at
// most together. Behind the sums: shared/face_list.glsl.
#include "shared/blocks.glsl"

layout(std430, binding = VCT_SSBO_FACE_SUMS) buffer FaceSumBlock {
    uint faceSums[];  // per slot, per face: VCT_FACE_SUM_*
};

#define VCT_FACE_SUM_COVERAGE 0u
#define VCT_FACE_SUM_RADIANCE 1u  // three, relative to E/pi over frame.faces.y
#define VCT_FACE_SUM_ALBEDO 4u    // three

uint faceSumIndex(uint slot, int face) {
    return (slot * 6u + uint(face)) * VCT_FACE_SUM_WORDS;
}

void addFixed(uint index, vec3 value) {
    uvec3 fixedPoint = uvec3(clamp(value, 0.0, 1.0) * frame.faces.x + 0.5);
    if (fixedPoint.x != 0u) atomicAdd(faceSums[index], fixedPoint.x);
    if (fixedPoint.y != 0u) atomicAdd(faceSums[index + 1u], fixedPoint.y);
    if (fixedPoint.z != 0u) atomicAdd(faceSums[index + 2u], fixedPoint.z);
}

// `weight` in 0..1, `radiance` relative to E/pi. Returns whether the face was empty until now.
bool addToFace(uint slot, int face, float weight, vec3 albedo, vec3 radiance) {
    uint index = faceSumIndex(slot, face);
    // Where nothing is covered nothing may be added: by its coverage it is known whether a face is empty.
    uint coverage = uint(weight * frame.faces.x + 0.5);
    if (coverage == 0u) return false;
    bool first = atomicAdd(faceSums[index + VCT_FACE_SUM_COVERAGE], coverage) == 0u;
    addFixed(index + VCT_FACE_SUM_RADIANCE, weight / frame.faces.y * radiance);
    addFixed(index + VCT_FACE_SUM_ALBEDO, weight * albedo);
    return first;
}

// A face's share of the voxel's cross-section, and premultiplied by it radiance and albedo. More than one layer of
// surface in a voxel: it is covered, and shines with their mean.
struct FaceSum {
    float coverage;
    vec3 radiance;  // relative to E/pi over frame.faces.y
    vec3 albedo;
};

vec3 threeSums(uint index) {
    return vec3(uvec3(faceSums[index], faceSums[index + 1u], faceSums[index + 2u]));
}

// Of a face that is not empty.
FaceSum faceSum(uint slot, int face) {
    uint index = faceSumIndex(slot, face);
    float sum = float(faceSums[index]);
    float scale = 1.0 / max(sum, frame.faces.x);
    return FaceSum(sum * scale, threeSums(index + VCT_FACE_SUM_RADIANCE) * scale,
                   threeSums(index + VCT_FACE_SUM_ALBEDO) * scale);
}
