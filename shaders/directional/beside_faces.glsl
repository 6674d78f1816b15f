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
    ivec3 voxel, first;  // of the face, and of its cascade
    int axis;            // of the face
    vec2 along;          // unit vector across the face
    float height;        // of the surface in the voxel
    float slope;
};
Row rowOf(ListedFace listed, SurfacePlane plane, vec2 along) {
    int axis = listed.face >> 1;
    return Row(listed.voxel, firstOfCascade(listed.voxel, frame.gridSide), axis, along,
               clamp(plane.offset / plane.normal[axis], -0.499, 0.499),
               -dot(acrossFaces(plane.normal, axis), along) / plane.normal[axis]);
}
// The faces of the voxel `aside` along the row, `above` voxels in front of the surface: static ones, or
// dynamic ones if the static ones lack `face`. `face`: -1 for any.
uint cellBeside(Row row, int aside, int above, int face) {
    int height = int(floor(row.height + row.slope * float(aside) + 0.5)) + above;
    ivec3 voxel = row.voxel + ivec3(fromAcross(row.along * float(aside), float(height), row.axis));
    if (voxel != clamp(voxel, row.first, row.first + frame.gridSide - 1)) return 0u;
    uint cell = texelFetch(staticIndex, voxel, 0).r;
    bool isFound = face < 0 ? cell != 0u : hasFace(cell, face);
    return isFound || frame.hasDynamicObjects == 0 ? cell : texelFetch(dynamicIndex, voxel, 0).r;
}

WeightedMean meanAlong(ListedFace listed, uint id, vec2 along) {
    Row row = rowOf(listed, facePlane(id), along);
    // A wall that stands on the surface between two faces has faces of its own in front of it.
    const int inFront = 2;
    int above = (listed.face & 1) == 0 ? inFront : -inFront;
    WeightedMean sum = besideMean(id);
    sum.mean *= sum.weight;
    bool isBehind = false;
    for (int i = 0; i < 4; ++i) {
        int steps = 1 + (i & 1), aside = i < 2 ? -steps : steps;
        if (isRefining() && steps == 2) continue;
        isBehind = steps == 2 && isBehind || cellBeside(row, aside, above, -1) != 0u;
        uint cell = cellBeside(row, aside, 0, listed.face);
        if (isBehind || !hasFace(cell, listed.face)) continue;
        WeightedMean beside = besideMean(faceId(cell, listed.face));
        float weight = beside.weight / float(isRefining() ? 2 : steps);
        sum.mean += weight * beside.mean;
        sum.weight += weight;
    }
    if (sum.weight > 0.0) sum.mean /= sum.weight;
    return sum;
}
