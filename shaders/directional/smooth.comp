// Removes the noise of the cached rays from the irradiance of each face, and writes the radiance that the
// face sends in the next step.
//
// Neighbouring faces trace different directions: 4 x 4 of them have the whole set. So the mean over a window
// of 4 x 4 faces has no noise, but blurs. The window is 5 x 5 faces wide, with half weights at its sides, so
// that it is centred and each of the 16 kinds of faces has the same weight (interleaved sampling: Keller and
// Heidrich 2001). Along creases irradiance varies too fast for that.
//
// The refined mean of a face is neither noisy nor blurred, but it is of an earlier light. What is shown is
// the smooth mean, and the difference between the two as it was, in proportion if the light has become less.
#include "directional/face_lists.glsl"
#include "directional/face_irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D staticIndex;
layout(binding = VCT_TEX_DYNAMIC_VOXELS) uniform highp usampler3D dynamicIndex;

// The 5 x 5 columns of voxels around a face, along its axis.
struct Window {
    ivec3 voxel, first;  // of the face, and of its cascade
    int axis;
    float height;  // of the surface in the voxel
    vec2 slope;
};
// The voxel of a column, `above` voxels in front of the surface, or one with a negative x outside of the
// cube.
ivec3 voxelOf(Window window, ivec2 aside, int above) {
    int along = int(floor(window.height + dot(window.slope, vec2(aside)) + 0.5)) + above;
    ivec3 voxel = window.voxel + ivec3(fromAcross(vec2(aside), float(along), window.axis));
    return voxel == clamp(voxel, window.first, window.first + frame.gridSide - 1) ? voxel : ivec3(-1);
}
uint facesOf(ivec3 voxel) {
    if (voxel.x < 0) return 0u;
    uint faces = texelFetch(staticIndex, voxel, 0).r;
    if (frame.hasDynamicObjects != 0) faces |= texelFetch(dynamicIndex, voxel, 0).r;
    return faces & VCT_FACE_MASK;
}

vec4 windowMean(ListedFace listed, uint id, vec4 now) {
    // A face inside of a solid takes the light of those beside it.
    float own = isHidden(id) ? 0.0 : closeness(faceSight(id).nearness);
    SurfacePlane plane = facePlane(id);
    int axis = listed.face >> 1;
    Window window = Window(listed.voxel, firstOfCascade(listed.voxel, frame.gridSide), axis,
                           clamp(plane.offset / plane.normal[axis], -0.499, 0.499),
                           -acrossFaces(plane.normal, axis) / plane.normal[axis]);
    // A wall that stands on the surface between two faces has faces of its own in front of it.
    const int inFront = 2;
    int above = (listed.face & 1) == 0 ? inFront : -inFront;
    uint walls = 0u;
    for (int i = 0; i < 25; ++i) {
        COUNT(VCT_COUNTER_SMOOTH_NEIGHBOUR);
        if (facesOf(voxelOf(window, ivec2(i % 5, i / 5) - 2, above)) != 0u) walls |= 1u << i;
    }
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int i = 0; i < 25; ++i) {
        ivec2 aside = ivec2(i % 5, i / 5) - 2, between = (aside + sign(aside)) / 2;
        ivec3 voxel = voxelOf(window, aside, 0);
        bool isBehind = ((walls >> i | walls >> (12 + between.x + 5 * between.y)) & 1u) != 0u;
        if (voxel.x < 0 || isBehind && i != 12) continue;
        uint cell = texelFetch(staticIndex, voxel, 0).r;
        if (!hasFace(cell, listed.face) && frame.hasDynamicObjects != 0)
            cell = texelFetch(dynamicIndex, voxel, 0).r;
        if (!hasFace(cell, listed.face)) continue;
        uint beside = faceId(cell, listed.face);
        float weight = (abs(aside.x) == 2 ? 0.5 : 1.0) * (abs(aside.y) == 2 ? 0.5 : 1.0);
        if (isHidden(beside)) weight = 0.0;
        sum += weight * faceMean(beside, VCT_MEAN_NOW);
        weights += weight;
    }
    return weights > 0.0 ? mix(sum / weights, now, own) : now;
}

// A refined mean, corrected by how the smooth mean has changed since. `known`: the smooth mean then.
vec4 corrected(vec4 smoothNow, vec4 known, vec4 refined) {
    vec4 share = mix(min(smoothNow / max(known, 1e-6), 1.0), vec4(1.0), lessThanEqual(known, vec4(0.0)));
    return max(smoothNow + share * (refined - known), 0.0);
}

void main() {
    COUNT(VCT_COUNTER_SMOOTH);
    if (gl_GlobalInvocationID.x == 0u) blockedRays = 0u;  // for the next step
    uint count = baseFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_SMOOTH_FACE);
        uint id = baseFaceId(i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged) continue;
        vec4 now = faceMean(id, VCT_MEAN_NOW), smoothNow = windowMean(listed, id, now);
        if (lightStep.interrupts != 0u) {
            // The light that is shown in the middle of a refinement becomes the refined mean.
            storeFaceMean(id, VCT_MEAN_REFINED, faceMean(id, VCT_MEAN_SHOWN));
            storeFaceMean(id, VCT_MEAN_KNOWN, faceMean(id, VCT_MEAN_SMOOTH));
        }
        vec4 before = faceMean(id, VCT_MEAN_SHOWN);
        vec4 known = faceMean(id, VCT_MEAN_KNOWN), refined = faceMean(id, VCT_MEAN_REFINED);
        vec4 shown = corrected(smoothNow, known, refined);
        if (lightStep.refiningWeight > 0.0) {
            vec4 next = max(now + faceMean(id, VCT_MEAN_GAIN), 0.0);
            shown = mix(shown, next, lightStep.refiningWeight);
        }
        // A face that has taken over its light shows that until it has traced rays of its own.
        FaceSight sight = faceSight(id);
        if (before.rgb != vec3(0.0))
            shown = mix(before, shown, min(float(sight.rays + sight.backs) / float(VCT_DIRECTIONS), 1.0));
        if (lightStep.endsRefinement != 0u) {
            storeFaceMean(id, VCT_MEAN_REFINED, shown);
            storeFaceMean(id, VCT_MEAN_KNOWN, smoothNow);
        }
        storeFaceMean(id, VCT_MEAN_SMOOTH, smoothNow);
        storeFaceMean(id, VCT_MEAN_SHOWN, shown);
        vec3 albedo = unpackRgb9e5(faceData[faceAt(id) + VCT_FACE_REFLECTANCE]);
        vec3 own = unpackRgb9e5(faceIrradianceData[irradianceAt(id) + VCT_FACE_DIRECT]);
        faceData[faceAt(id) + VCT_FACE_RADIANCE] =
            packRgb9e5(own + reflectedBounces(albedo, shown.rgb + emitterIrradiance(id)));
    }
}
