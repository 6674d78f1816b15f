// Packs radiance, planes, surfaces and extents of faces into words, and cells into the index of the voxels.
#include "directional/voxels.glsl"
#include "shared/normals.glsl"

// Radiance in 32 bits: three mantissas of 9 bits and an exponent of 5 (EXT_texture_shared_exponent). Channels
// are precise to 1/512 of the largest one, from 6e-5 to 65408. So a lamp and the third bounce of its light
// fit beside each other.
uint packRgb9e5(vec3 value) {
    value = clamp(value, 0.0, 65408.0);
    float largest = max(value.r, max(value.g, value.b));
    int exponent = clamp(int((floatBitsToUint(largest) >> 23u) & 255u) - 126, -15, 16);
    float scale = exp2(float(9 - exponent));
    if (floor(largest * scale + 0.5) > 511.0) {
        ++exponent;
        scale *= 0.5;
    }
    uvec3 mantissa = uvec3(value * scale + 0.5);
    return mantissa.r | mantissa.g << 9u | mantissa.b << 18u | uint(exponent + 15) << 27u;
}
// The unit of the mantissas of four words: 2^(exponent - 24), by the bits of a float, which cost less than
// exp2().
vec4 scaleOfRgb9e5(uvec4 words) {
    return uintBitsToFloat((words >> 27u) + 103u << 23u);
}
vec3 unpackRgb9e5(uint word) {
    return vec3(word & 511u, word >> 9u & 511u, word >> 18u & 511u) * scaleOfRgb9e5(uvec4(word)).x;
}

// The plane of the surface in a voxel: its normal, and its distance from the voxel's middle along the normal,
// in voxels, at most half the diagonal. Here and everywhere bits are masked one component at a time, because
// some Mali drivers compute "vector & constant" wrongly (Dolphin, DriverDetails.h,
// BUG_BROKEN_VECTOR_BITWISE_AND).
struct SurfacePlane {
    vec3 normal;
    float offset;
};

// The key is in the highest bits, so that atomicMax() keeps the plane of the fragment with the largest one.
// `isCurved`: the normals differ from the triangle's, as on a round surface made of flat triangles.
uint packPlane(float key, bool isCurved, vec3 normal, float offset) {
    uvec2 steps = uvec2(vec2(key, clamp(offset, -1.0, 1.0) * 0.5 + 0.5) * vec2(127.0, 255.0) + 0.5);
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

// The point of a plane in a voxel, from the voxel's middle, whose components across the face are `place`.
vec3 pointOnPlane(SurfacePlane plane, int axis, vec2 place) {
    vec2 across = acrossFaces(plane.normal, axis);
    float along = (plane.offset - dot(across, place)) / plane.normal[axis];
    return fromAcross(place, along, axis);
}

// A voxel's texel in the index: a bit per occupied face, and above them the id of its first face, counted
// from 1. The texel is 0 if the voxel or its faces did not fit into the lists. Between the two passes over
// the triangles it has the bits alone.
uint packCell(uint firstId, uint faces) {
    return (firstId + 1u) << VCT_FACE_MASK_BITS | faces;
}
bool hasFace(uint cell, int face) {
    return (cell >> uint(face) & 1u) != 0u;
}
// The id of an occupied face.
uint faceId(uint cell, int face) {
    return (cell >> VCT_FACE_MASK_BITS) - 1u + uint(bitCount(cell & ((1u << uint(face)) - 1u)));
}

// The surface that blocks rays, of static and dynamic geometry together: the plane in the lower 24 bits, and
// above them the opacity of the covered part (packExtent()).
uint packSurface(uint plane, float opacity) {
    return uint(clamp(opacity, 0.0, 1.0) * 255.0 + 0.5) << 24 | (plane & 0xFFFFFFu);
}
// The opacity of a part that stops all rays, which test whether they meet it (covers() in
// directional/ray.glsl).
const uint opaqueInPart = 254u;
float opacityOf(uint surface) {
    return float(surface >> 24) / 255.0;
}

// The part of its plane that a surface covers in the voxel.
struct FaceExtent {
    float coverage;  // of the voxel's cross-section, 0..1
    bool isCurved;
    vec2 place;  // middle of the covered part across the face, from the voxel's middle
    // A bit per face of the voxel: the covered part is in front of that face's plane, or behind it. Both: the
    // surface goes on behind that face, which is of a thin wall, and the voxel beside it has that part. Both
    // for the surface's own face: the thin wall's face is of the voxel in front.
    uint inFront, behind;
};

ivec3 voxelInFront(ivec3 voxel, int face) {
    return voxel + ((face & 1) == 0 ? 1 : -1) * ivec3(equal(ivec3(face >> 1), ivec3(0, 1, 2)));
}

// The face of a thin wall behind which a surface goes on; -1: none. `own`: the surface's face of `voxel`.
struct WallFace {
    ivec3 voxel;
    int face;
};
WallFace wallAcross(FaceExtent extent, ivec3 voxel, int own) {
    uint both = extent.inFront & extent.behind, isInFront = both >> uint(own) & 1u;
    return WallFace(isInFront != 0u ? voxelInFront(voxel, own) : voxel, findLSB(both & ~(1u << uint(own))));
}
uint packExtent(FaceExtent extent) {
    uvec2 place = uvec2(clamp(extent.place + 0.5, 0.0, 1.0) * 62.0 + 0.5);
    return uint(min(extent.coverage, 1.0) * 127.0 + 0.5) << 25 | (extent.isCurved ? 1u << 24 : 0u) |
           place.x << 18 | place.y << 12 | extent.inFront << 6 | extent.behind;
}
FaceExtent unpackExtent(uint word) {
    return FaceExtent(float(word >> 25) / 127.0, (word & 1u << 24) != 0u,
                      vec2(word >> 18 & 63u, word >> 12 & 63u) / 62.0 - 0.5, word >> 6 & 63u, word & 63u);
}
