// Writes the surface and the material of each base-level face from its sums, after it has been voxelized.
// directional/extents.comp finds where the surface ends.
#include "directional/resolved.glsl"

// The sums of a face. If static and dynamic geometry share it, the words of the static geometry alone are
// moved to the id of the dynamic face.
FaceSums sumsOf(ResolvedFace own) {
    if (own.dynamicId == noIds) return faceSums(own.id);
    uint from = faceAt(own.id), to = faceAt(own.dynamicId);
    for (uint word = 0u; word < faceWords; ++word)
        faceData[to + word] = faceData[from + word];
    return combine(keptSums(own.id, own.face), faceSums(own.dynamicId));
}

void main() {
    uint count = faceCount(list), stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        ResolvedFace own = resolvedFace(i);
        if (!own.changes) continue;
        FaceSums sums = sumsOf(own);
        uint visible = visiblePlane(sums, own.face);
        float weight = max(sums.coverage, 1e-4);
        uint at = faceAt(own.id);
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
