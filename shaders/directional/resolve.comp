// Writes the surface and the material of each base-level face from its sums, after a pose has been voxelized.
// directional/extents.comp finds where the surface ends.
#include "directional/resolved.glsl"

void main() {
    uint count = visitedFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(i);
        ResolvedFace own = resolvedFace(id);
        if (!own.changes) continue;
        FaceSums sums = combinedSums(own.staticCell, movingCell(own), own.face);
        uint visible = visiblePlane(sums, own.face);
        float weight = max(sums.coverage, 1e-4);
        uint at = faceAt(id);
        faceData[at + VCT_FACE_SURFACE] = packSurface(visible, 1.0);
        faceData[at + VCT_FACE_EXTENT] =
            packExtent(FaceExtent(sums.coverage, isCurved(visible), sums.place / weight - 0.5, 0u, 0u));
        faceData[at + VCT_FACE_REFLECTANCE] = packRgb9e5(visibleAlbedo(sums));
#ifdef VCT_EMISSION
        // Emissions of several layers are added, because a lamp directly below a ceiling hides the ceiling
        // and must not be darkened by its layer.
        float layer = hasLayers(sums) ? min(sums.coverage, 1.0) : weight;
        faceData[at + VCT_FACE_EMITTED] = packRgb9e5(sums.emission / layer);
#endif
    }
}
