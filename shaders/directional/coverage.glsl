// What a fragment covers of the faces of its voxel. Both passes over the triangles include this, so that they agree on
// which faces a fragment is in.
#include "shared/material.glsl"
#include "directional/face_sums.glsl"

in vec3 fragmentPosition;

// What the surface covers of each of the voxel's cross-sections: of the faces towards +x, +y, +z where positive, -x, -y, -z
// where negative. It is the face's normal over its component along the projection, times a pixel's area in voxels.
// Derivatives need the whole quad: call this before any discard.
vec3 fragmentCoverage() {
    vec3 positionVoxels = fragmentPosition * float(frame.gridSide);
    vec3 coverage = clamp(cross(dFdx(positionVoxels), dFdy(positionVoxels)), -1.0, 1.0);
    return gl_FrontFacing ? coverage : -coverage;
}

ivec3 fragmentVoxel() {
    return clamp(ivec3(floor(fragmentPosition * float(frame.gridSide))), ivec3(0), ivec3(frame.gridSide - 1));
}

// A bit for each face of which the fragment covers something.
uint coveredFaces(vec3 coverage) {
    uint faces = 0u;
    if (fixedCoverage(abs(coverage.x)) > 0u) faces |= coverage.x > 0.0 ? 1u : 2u;
    if (fixedCoverage(abs(coverage.y)) > 0u) faces |= coverage.y > 0.0 ? 4u : 8u;
    if (fixedCoverage(abs(coverage.z)) > 0u) faces |= coverage.z > 0.0 ? 16u : 32u;
    return faces;
}
