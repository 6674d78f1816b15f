// Removes the noise of the cached rays from the irradiance of each face, and writes the radiance that the
// face sends in the next step.
//
// Neighbouring faces trace different directions: 4 x 4 of them have the whole set. So the mean over a window
// of 4 x 4 faces has no noise, but blurs. The window is 5 x 5 faces wide, with half weights at its sides, so
// that it is centred and each of the 16 kinds of faces has the same weight (interleaved sampling: Keller and
// Heidrich 2001). The window is the product of two rows: directional/smooth_rows.comp takes the mean along
// the first axis across the face, and this pass the mean of those along the second.
//
// The refined mean of a face is of many more rays, which leave the spots of small bright surfaces; the
// smaller window removes these. It is of an earlier light. What is shown is the smooth mean over the cached
// rays, and the difference between the two as it was, in proportion if the light has become less.
#include "directional/beside_faces.glsl"
#include "directional/visited.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

WeightedMean besideMean(uint id) {
    WeightedMean row;
    row.mean = faceRow(id, row.weight);
    return row;
}

// A refined mean, corrected by how the smooth mean has changed since. `known`: the smooth mean then.
vec4 corrected(vec4 smoothNow, vec4 known, vec4 refined) {
    vec4 share = mix(min(smoothNow / max(known, 1e-6), 1.0), vec4(1.0), lessThanEqual(known, vec4(0.0)));
    return max(smoothNow + share * (refined - known), 0.0);
}

// Keeps a refined mean with the smooth mean of its time. Inside of a moving object, the refining rays show
// nothing of the light that a face receives once the object has left it.
void storeRefined(uint id, vec4 refined, vec4 known) {
    storeFaceMean(id, VCT_MEAN_REFINED, isHidden(id) ? known : refined);
    storeFaceMean(id, VCT_MEAN_KNOWN, known);
}

void main() {
    if (gl_GlobalInvocationID.x == 0u) blockedRays = 0u;  // for the next step
    uint count = visitedFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged) continue;
        // A face inside of a solid takes the light of those beside it.
        WeightedMean column = meanAlong(listed, id, 1);
        vec4 window = column.weight > 0.0 ? column.mean : unsmoothedMean(id);
        // The mean over the cached rays does not change in a refinement.
        vec4 smoothNow = isRefining() ? faceMean(id, VCT_MEAN_SMOOTH) : window;
        if (lightStep.interrupts != 0u) {
            // The light that is shown in the middle of a refinement becomes the refined mean.
            storeRefined(id, faceMean(id, VCT_MEAN_SHOWN), faceMean(id, VCT_MEAN_SMOOTH));
        }
        vec4 before = faceMean(id, VCT_MEAN_SHOWN);
        vec4 known = faceMean(id, VCT_MEAN_KNOWN), refined = faceMean(id, VCT_MEAN_REFINED);
        vec4 shown = corrected(smoothNow, known, refined);
        if (isRefining()) shown = mix(shown, window, lightStep.refiningWeight);
        // A face that has taken over its light shows that until it has traced rays of its own.
        FaceSight sight = faceSight(id);
        if (lightStep.startsDark == 0u && before.rgb != vec3(0.0))
            shown = mix(before, shown, min(float(sight.rays + sight.backs) / float(VCT_DIRECTIONS), 1.0));
        if (lightStep.endsRefinement != 0u) {
#if VCT_CASCADES > 1
            if (id < commands[0].faceCapacity) storeChange(id, 0u);
#endif
            storeRefined(id, shown, smoothNow);
        }
        storeFaceMean(id, VCT_MEAN_SMOOTH, smoothNow);
        storeFaceMean(id, VCT_MEAN_SHOWN, shown);
        vec3 albedo = unpackRgb9e5(faceData[faceAt(id) + VCT_FACE_REFLECTANCE]);
        vec3 own = unpackRgb9e5(faceIrradianceData[irradianceAt(id) + VCT_FACE_DIRECT]);
        faceData[radianceAt(id)] =
            packRgb9e5(own + reflectedBounces(albedo, shown.rgb + emitterIrradiance(id)));
    }
}
