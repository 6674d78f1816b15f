// The coverage of a voxel's faces by a fragment. Both passes over the triangles include this file, so that
// they agree on the faces that a fragment covers.
#include "shared/material.glsl"
#include "directional/cascades.glsl"
#include "directional/face_sums.glsl"

in vec3 fragmentPosition;

// Coverage of the voxel's cross-section along each axis: positive for the face towards +x, +y, +z, negative
// for the face towards -x, -y, -z. It is the normal divided by its component along the projection, times the
// area of a pixel in voxels. Call it before any discard, because derivatives need the whole quad.
vec3 fragmentCoverage() {
    vec3 positionVoxels = fragmentPosition * float(frame.gridSide);
    vec3 coverage = clamp(cross(dFdx(positionVoxels), dFdy(positionVoxels)), -1.0, 1.0);
    return gl_FrontFacing ? coverage : -coverage;
}

// The fragment's voxel in its cascade.
ivec3 fragmentVoxel() {
    return clamp(ivec3(floor(fragmentPosition * float(frame.gridSide))), ivec3(0), ivec3(frame.gridSide - 1));
}

// The same voxel where the lists and textures have it, behind those of finer cascades.
#if VCT_CASCADES > 1
layout(location = VCT_UNIFORM_CASCADE) uniform uint cascade;  // cascade that triangles are voxelized into
layout(location = VCT_UNIFORM_SHIFT) uniform uint shift;      // packShift() of its move
ivec3 listedVoxel(ivec3 voxel) {
    return voxel + ivec3(0, 0, int(cascade) * frame.gridSide);
}
// True if the cascade held a voxel before it moved. Then the voxel has its faces.
bool isKept(ivec3 voxel) {
    ivec3 before = voxel + unpackShift(shift);
    return before == clamp(before, ivec3(0), ivec3(frame.gridSide - 1));
}
#else
ivec3 listedVoxel(ivec3 voxel) {
    return voxel;
}
bool isKept(ivec3 voxel) {
    return false;
}
#endif

// One bit for each face that the fragment covers. Less than a slope of 1/500 covers nothing.
bool isCovered(float coverage) {
    return coverage > 1.0 / 8192.0 && fixedCoverage(coverage) > 0u;
}
uint coveredFaces(vec3 coverage) {
    uint faces = 0u;
    if (isCovered(abs(coverage.x))) faces |= coverage.x > 0.0 ? 1u : 2u;
    if (isCovered(abs(coverage.y))) faces |= coverage.y > 0.0 ? 4u : 8u;
    if (isCovered(abs(coverage.z))) faces |= coverage.z > 0.0 ? 16u : 32u;
    return faces;
}
