// The mean of a face and its neighbours along one of the two axes across the face, the first half of the
// smoothing in a window (directional/smooth.comp). Of a mean over the cached rays the window has 5 x 5 faces,
// with the weights 1/2, 1, 1, 1 and 1/2 along an axis; of a refined mean, which is less noisy, 3 x 3 faces
// with 1/2, 1 and 1/2. Faces that directional/link_faces.comp has not linked do not count, and those that are
// nearer to other surfaces or further away count less: irradiance varies fast across a crease, but not along
// it. The including shader reads the neighbours: besideMean().
#include "directional/rows.glsl"
#include "directional/face_irradiance.glsl"

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

// `axis`: 0 or 1, the axis across the face that the row follows.
WeightedMean meanAlong(ListedFace listed, uint id, int axis) {
    const float similarity = 3.0;
    WeightedMean sum = besideMean(id);
    float own = closeness(faceSight(id).nearness);
    sum.mean *= sum.weight;
    Row row = rowOf(listed, facePlane(id), axis == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0));
    // Bits for the faces -1, -2, 1 and 2 voxels away. The second one counts if the first is linked to it.
    uint linked = faceLinks(id) >> uint(2 * axis) & 3u, left = linked & 1u | (linked & 2u) << 1u;
    while (left != 0u) {
        int place = findLSB(left), side = place >> 1, steps = 1 + (place & 1);
        left &= left - 1u;
        ivec3 voxel = voxelOfRow(row, float(side == 0 ? -steps : steps));
        uint cell = cellBeside(row, voxel, 1u << uint(listed.face));
        if (!hasFace(cell, listed.face)) continue;
        uint besideId = faceId(cell, listed.face);
        if (steps == 1 && !isRefining())
            left |= (faceLinks(besideId) >> uint(2 * axis + side) & 1u) << uint(place + 1);
        WeightedMean beside = besideMean(besideId);
        float difference = abs(closeness(faceSight(besideId).nearness) - own);
        float weight =
            beside.weight / float(isRefining() ? 2 : steps) * max(1.0 - similarity * difference, 0.0);
        sum.mean += weight * beside.mean;
        sum.weight += weight;
    }
    if (sum.weight > 0.0) sum.mean /= sum.weight;
    return sum;
}
