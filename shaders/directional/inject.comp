// Injects light: writes the radiance that each face of level 0 emits and reflects,
//
//     aspect * (emission + albedo * (shadowed direct light at the face's plane + gain * face irradiance)).
//
// The aspect is explained at materialOf(). Also writes each face's plane and coverage (packSurface()), which
// the gather and the look-ups read. Static and dynamic geometry in the same face are added first.
// VCT_BOUNCES: face irradiance is included; without it, faces reflect direct light only.
#include "directional/face_range.glsl"
#include "directional/face_sums.glsl"
#include "directional/voxels.glsl"
#include "directional/cascades.glsl"
#include "shared/orthonormal.glsl"
#include "shared/shadow.glsl"
#ifdef VCT_PUNCTUAL_LIGHTS
#include "shared/punctual_lights.glsl"
#else
vec3 punctualIrradiance(vec3 position, vec3 normal, float slackShare) {
    return vec3(0.0);
}
#endif

layout(local_size_x = VCT_LIST_GROUP) in;
layout(binding = VCT_TEX_VOXELS) uniform highp usampler3D staticIndex;
layout(binding = VCT_TEX_DYNAMIC_VOXELS) uniform highp usampler3D dynamicIndex;
layout(rgba8, binding = VCT_IMAGE_FACES) writeonly uniform mediump image3D faces;
layout(location = VCT_UNIFORM_FRAME_INDEX) uniform uint frameIndex;

// Irradiance by the sun and the punctual lights, relative to E: the mean at four points of the face's plane,
// about 0.4 voxels from its middle. The plane can extend beyond the surface, for example where the walls of a
// room meet, and there the shadow map shows other surfaces. So a point counts only if all four texels around
// it show the surface itself, or if all of them block the light. If there is no such point, as on a thin bar,
// and most texels are lit, their share counts. `slackShare`: flatSlack or curvedSlack, the tolerance of the
// comparison with the surface's plane. `middle`: the middle of the plane in the voxel, in voxels of a
// cascade.
vec3 directIrradiance(SurfacePlane plane, float slackShare, vec3 middle, int cascade) {
    mat3 axes = frameAround(plane.normal);
    float cosTheta = dot(plane.normal, frame.directionToLight.xyz);
    SunMap map = sunMapAt(volumeFromVoxels(middle, cascade));
    vec2 slope = shadowSlope(map, plane.normal);
    float slack = sunSlack(slope, slackShare);
    vec2 points = vec2(0.0), texels = vec2(0.0);  // x: lit, y: blocked
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        COUNT(VCT_COUNTER_INJECT_POINT);
        vec2 aside = i < 2 ? vec2(0.125, 0.375) : vec2(0.375, -0.125);
        if ((i & 1) == 1) aside = -aside;
        vec3 position = volumeFromVoxels(middle + axes[0] * aside.x + axes[2] * aside.y, cascade);
        if (cosTheta > 0.0) {
            vec2 around = shadowTexels(shadowDepth, inSunMap(map, position), slope, slack);
            texels += around;
            points += vec2(equal(around, vec2(4.0)));
        }
        sum += 0.25 * punctualIrradiance(position, plane.normal, slackShare);
    }
    vec2 known = points == vec2(0.0) && texels.x > texels.y ? texels : points;
    return sum + max(cosTheta, 0.0) * (known.x / max(known.x + known.y, 1.0)) * frame.lightColor.rgb;
}

// True if the face's surface is one side of a sheet or a thin plate: the opposite face is covered too, and by
// a surface of the opposite normal. Where two walls meet at an edge, opposite faces have other normals.
bool hasBack(uint staticCell, uint dynamicCell, int face, FaceSums sums, vec3 normal) {
    int opposite = face ^ 1;
    if (!hasFace(staticCell | dynamicCell, opposite)) return false;
    FaceSums back = combinedSums(staticCell, dynamicCell, opposite);
    return back.coverage > 0.5 * min(sums.coverage, 1.0) &&
           dot(unpackPlane(back.plane).normal, normal) < -0.8;
}

// The larger of a number and a colour's largest component. NaN is ignored, because it fails the comparison.
float largerOf(float before, vec3 color) {
    float largest = max(color.r, max(color.g, color.b));
    return largest > before ? min(largest, 6e4) : before;
}

#ifdef VCT_BOUNCES
#include "directional/active_faces.glsl"
#include "directional/light_balance.glsl"

// While something changes, light is injected into the static faces of a cascade once in 2^cascade steps, so
// that a step costs about twice the finest cascade. Returns this number of steps; 1 for a face that is new to
// its cascade and has no radiance yet.
uint injectionPeriod(uint id, uint cascade) {
    bool isNew = faceData[id * faceWords + VCT_FACE_SURFACE] == 0u;
    bool atOnce = lightStep.coneBudget == 0u || lightStep.longEnough > 0.0 || faceRange.changed != 0.0;
    return cascades == 1 || isNew || atOnce ? 1u : 1u << cascade;
}

// While only cascades move, the light of faces that are not active stays, unless its range changes.
bool visitsAll() {
    return cascades == 1 || lightStep.longEnough == 0.0 || faceRange.changed != 0.0;
}
#else
bool visitsAll() {
    return true;
}
uint visitedFaceCount(bool everyFace) {
    return baseFaceCount();
}
uint visitedFaceId(bool everyFace, uint i) {
    return baseFaceId(i);
}
#endif

// The albedo and emission of a face, premultiplied by its coverage. If a voxel has several layers of surface,
// their albedos are averaged. Their emissions are added, because a lamp directly below a ceiling hides the
// ceiling and must not be darkened by its layer.
//
// A slanted surface covers up to three faces. Seen along the surface's normal, their coverages add up to the
// right one; seen from elsewhere they add up to more, so that the faces would send up to 1.7 times the light
// of the surface. If each face's light were scaled by the normal's component along its axis, the total would
// be right, but the surface would be too dark from the front, as in a closed slanted room. Scaling by the
// cube root of the component is a compromise (docs/history/cones.md, "Slanted surfaces").
struct FaceMaterial {
    vec3 albedo;
    vec3 emission;  // relative to E/pi
};
FaceMaterial materialOf(FaceSums sums, float normalComponent) {
    float aspect = pow(abs(normalComponent), 1.0 / 3.0);
    return FaceMaterial(sums.albedo * (aspect / max(sums.coverage, 1.0)), sums.emission * aspect);
}

// The largest radiance before it is clamped, for the range of the next step (directional/choose_range.comp).
shared uint groupLargestRadiance;

void main() {
    COUNT(VCT_COUNTER_INJECT);
    if (gl_LocalInvocationIndex == 0u) groupLargestRadiance = 0u;
    barrier();
    float radianceMeasured = 0.0;
#ifdef VCT_BOUNCES
    beginBalance();
#endif
    bool everyFace = visitsAll();
    uint count = visitedFaceCount(everyFace);
    bool hasDynamic = faceCount(dynamicList) > 0u;
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_INJECT_FACE);
        uint id = visitedFaceId(everyFace, i);
        ListedFace listed = baseFace(id);
        // The sums of a merged dynamic face are added to a static face, which is injected with both.
        if (listed.isMerged) continue;
        uint dynamicCell = hasDynamic ? texelFetch(dynamicIndex, listed.voxel, 0).r : 0u;
#ifdef VCT_BOUNCES
        uint period =
            hasFace(dynamicCell, listed.face) ? 1u : injectionPeriod(id, uint(cascadeOf(listed.voxel)));
        if ((i / uint(VCT_LIST_GROUP) + lightStep.frame) % period != 0u) continue;
#endif
        uint staticCell = texelFetch(staticIndex, listed.voxel, 0).r;
        FaceSums sums = combinedSums(staticCell, dynamicCell, listed.face);
        SurfacePlane plane = unpackPlane(sums.plane);
        float coverage = min(sums.coverage, 1.0);
        faceData[id * faceWords + VCT_FACE_SURFACE] = packSurface(
            sums.plane, coverage, hasBack(staticCell, dynamicCell, listed.face, sums, plane.normal));
        FaceMaterial material = materialOf(sums, plane.normal[listed.face >> 1]);
        vec3 middle = vec3(listed.voxel) + 0.5 + plane.normal * plane.offset;
        float slackShare = slackShareOf(isCurved(sums.plane));
        vec3 radiance = material.emission;
        if (material.albedo != vec3(0.0))
            radiance +=
                material.albedo * directIrradiance(plane, slackShare, middle, cascadeOf(listed.voxel));
#ifdef VCT_BOUNCES
        radiance = addBounces(id, listed.voxel, float(period), coverage, radiance, material.albedo);
#endif
        radianceMeasured = largerOf(radianceMeasured, radiance);
        radiance = min(radiance / faceRange.radiance, 1.0);
        ivec3 texel = faceTexel(listed.voxel, listed.face >> 1, listed.face & 1, frame.gridSide);
        imageStore(faces, texel, ditherToUnorm8(vec4(radiance, coverage), texel, frameIndex));
    }
    atomicMax(groupLargestRadiance, floatBitsToUint(radianceMeasured));
    barrier();
    if (gl_LocalInvocationIndex == 0u) atomicMax(largestRadiance, groupLargestRadiance);
#ifdef VCT_BOUNCES
    endBalance();
#endif
}
