// The mean of a face and its neighbours along one of the two axes across the face, the first half of the
// smoothing in a window (directional/smooth.comp). Of a mean over the cached rays the window has 5 x 5 faces,
// with the weights 1/2, 1, 1, 1 and 1/2 along an axis; of a refined mean, which is less noisy, 3 x 3 faces
// with 1/2, 1 and 1/2. The including shader reads the neighbours: besideMean().
#include "directional/face_lists.glsl"
#include "directional/face_irradiance.glsl"

layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D staticIndex;
layout(binding = VCT_TEX_DYNAMIC_VOXELS) uniform highp usampler3D dynamicIndex;

// A mean over faces, and the sum of their weights.
struct WeightedMean {
    vec4 mean;
    float weight;
};
WeightedMean besideMean(uint id);

bool isRefining() {
    return lightStep.refiningWeight > 0.0;
}
// The mean that the window smooths: over the cached rays, or over those of the present refinement.
vec4 unsmoothedMean(uint id) {
    vec4 now = faceMean(id, VCT_MEAN_NOW);
    return isRefining() ? max(now + faceMean(id, VCT_MEAN_GAIN), 0.0) : now;
}

// The voxels beside a face, along an axis across it.
struct Row {
    vec3 voxel;      // of the face
    ivec3 first;     // of its cascade
    vec3 along, up;  // unit vectors: of the row, and of the axis that the face looks along
    float height;    // of the surface in the voxel
    float slope;
};
Row rowOf(ListedFace listed, SurfacePlane plane, vec2 along) {
    int axis = listed.face >> 1;
    float steepness = 1.0 / plane.normal[axis];
    return Row(vec3(listed.voxel), firstOfCascade(listed.voxel, frame.gridSide), fromAcross(along, 0.0, axis),
               fromAcross(vec2(0.0), 1.0, axis), clamp(plane.offset * steepness, -0.499, 0.499),
               -dot(acrossFaces(plane.normal, axis), along) * steepness);
}
// The voxel of the surface `aside` along the row.
vec3 voxelBeside(Row row, float aside) {
    float height = floor(row.height + row.slope * aside + 0.5);
    return row.voxel + aside * row.along + height * row.up;
}
// The faces of a voxel: static ones, or dynamic ones if the static ones lack `faces`. None outside of the
// cascade.
uint cellBeside(Row row, vec3 beside, uint faces) {
    ivec3 voxel = ivec3(beside);
    if (any(greaterThanEqual(uvec3(voxel - row.first), uvec3(frame.gridSide)))) return 0u;
    uint cell = texelFetch(staticIndex, voxel, 0).r;
    bool isFound = (cell & faces) != 0u;
    return isFound || frame.hasDynamicObjects == 0 ? cell : texelFetch(dynamicIndex, voxel, 0).r;
}

WeightedMean meanAlong(ListedFace listed, uint id, vec2 along) {
    Row row = rowOf(listed, facePlane(id), along);
    // A wall that stands on the surface between two faces has faces of its own in front of it.
    const int inFront = 2;
    vec3 above = row.up * float((listed.face & 1) == 0 ? inFront : -inFront);
    WeightedMean sum = besideMean(id);
    sum.mean *= sum.weight;
    bool isBehind = false;
    for (int i = 0; i < 4; ++i) {
        int steps = 1 + (i & 1), aside = i < 2 ? -steps : steps;
        if (isRefining() && steps == 2) continue;
        vec3 voxel = voxelBeside(row, float(aside));
        isBehind = steps == 2 && isBehind || cellBeside(row, voxel + above, VCT_FACE_MASK) != 0u;
        uint cell = cellBeside(row, voxel, 1u << uint(listed.face));
        if (isBehind || !hasFace(cell, listed.face)) continue;
        WeightedMean beside = besideMean(faceId(cell, listed.face));
        float weight = beside.weight / float(isRefining() ? 2 : steps);
        sum.mean += weight * beside.mean;
        sum.weight += weight;
    }
    if (sum.weight > 0.0) sum.mean /= sum.weight;
    return sum;
}
