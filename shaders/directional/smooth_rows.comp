// The mean of each face's irradiance and that of its neighbours along the first axis across the face, for
// directional/smooth.comp.
#include "directional/beside_faces.glsl"
#include "directional/visited.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// Rays inside of a solid see no light.
WeightedMean besideMean(uint id) {
    return WeightedMean(unsmoothedMean(id), isHidden(id) ? 0.0 : 1.0);
}

void main() {
    uint count = visitedFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged) continue;
        WeightedMean row = meanAlong(listed, id, 0);
        storeFaceRow(id, row.mean, row.weight);
    }
}
