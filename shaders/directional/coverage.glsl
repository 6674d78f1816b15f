// The coverage of voxels' faces by a fragment. Both passes over the triangles include this file, so that they
// agree on the faces that a fragment covers.
#include "shared/material.glsl"
#include "directional/cascades.glsl"

#ifndef VCT_PIXEL_SAMPLES
#define VCT_PIXEL_SAMPLES 4
#endif

in vec3 fragmentPosition;

// From the pixel's middle, in pixels. Of four samples, the standard places (Vulkan, standardSampleLocations).
// A driver with others moves what it covers by an eighth of a voxel at most.
#if VCT_PIXEL_SAMPLES == 1
const vec2 samplePlaces[1] = vec2[1](vec2(0.0));
#else
const vec2 samplePlaces[4] =
    vec2[4](vec2(-0.125, -0.375), vec2(0.375, -0.125), vec2(-0.375, 0.125), vec2(0.125, 0.375));
#endif

// Converts coverage in 0..1 to fixed point. If the result is 0, the fragment must not add to the face.
uint fixedCoverage(float weight) {
    return uint(weight * frame.faceSumUnits + 0.5);
}

// Samples of a fragment's pixel, of which a voxel has 4 x 4 across the projection.
struct Samples {
    vec3 middle, right, up;  // the pixel's middle and the steps to the next pixels, in voxels
    uint left;               // a bit for each sample that the triangle covers and no part has
};

// Call it before any discard, because derivatives need the whole quad.
Samples fragmentSamples() {
    vec3 middle = fragmentPosition * float(frame.gridSide);
#if VCT_PIXEL_SAMPLES == 1
    uint covered = 1u;
#else
    // A driver may give a pixel more samples than asked. Those are as good as the others.
    uint covered = uint(gl_SampleMaskIn[0]) & (1u << uint(VCT_PIXEL_SAMPLES)) - 1u;
#endif
    return Samples(middle, dFdx(middle), dFdy(middle), covered);
}

// The samples in one voxel.
struct Part {
    ivec3 voxel;  // in its cascade
    vec3 place;   // mean of the samples, in voxels
    // Coverage of the voxel's cross-section along each axis: positive for the face towards +x, +y, +z,
    // negative for the face towards -x, -y, -z. It is the normal divided by its component along the
    // projection, times the area of the samples in voxels.
    vec3 coverage;
};

vec3 sampleAt(Samples samples, int i) {
    return samples.middle + samplePlaces[i].x * samples.right + samplePlaces[i].y * samples.up;
}
ivec3 voxelAt(vec3 place) {
    return clamp(ivec3(floor(place)), ivec3(0), ivec3(frame.gridSide - 1));
}

// Takes the samples in one voxel. A surface that slants away has samples of a pixel in two voxels at most,
// one behind the other.
Part nextPart(inout Samples samples) {
    Part part = Part(voxelAt(sampleAt(samples, findLSB(samples.left))), vec3(0.0), vec3(0.0));
    float count = 0.0;
    for (int i = 0; i < VCT_PIXEL_SAMPLES; ++i) {
        vec3 place = sampleAt(samples, i);
        if ((samples.left >> uint(i) & 1u) == 0u || voxelAt(place) != part.voxel) continue;
        part.place += place;
        count += 1.0;
        samples.left ^= 1u << uint(i);
    }
    part.place /= count;
    part.coverage = clamp(count / float(VCT_PIXEL_SAMPLES) * cross(samples.right, samples.up), -1.0, 1.0);
    if (!gl_FrontFacing) part.coverage = -part.coverage;
    return part;
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
