// Injects light: writes the radiance that each face of the base level emits and reflects,
//
//     emission + albedo * (shadowed direct light at the face's plane + face irradiance).
//
// It runs when a light or an object has changed. Between such changes, smooth.comp adds the bounces to what
// the face emits and reflects of direct light.
#include "directional/visited.glsl"
#include "directional/face_irradiance.glsl"
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

// Irradiance by the sun and the punctual lights, relative to E: the mean at four points of the face's plane,
// about 0.4 voxels from its middle. The plane can extend beyond the surface, for example where the walls of a
// room meet, and there the shadow map shows other surfaces. So a point counts only if all four texels around
// it show the surface itself, or if all of them block the light. If there is no such point, as on a thin bar,
// and most texels are lit, their share counts. `slackShare`: flatSlack or curvedSlack, the tolerance of the
// comparison with the surface's plane. `middle`: of the surface in the voxel, in voxels of a cascade.
vec3 directIrradiance(SurfacePlane plane, float slackShare, vec3 middle, int cascade) {
    mat3 axes = frameAround(plane.normal);
    float cosTheta = dot(plane.normal, frame.directionToLight.xyz);
    SunMap map = sunMapAt(volumeFromVoxels(middle, cascade));
    vec2 slope = shadowSlope(map, coneSlope(plane.normal));
    float slack = sunSlack(slope, slackShare);
    vec2 points = vec2(0.0), texels = vec2(0.0);  // x: lit, y: blocked
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
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

// A face's emission and reflected direct light.
vec3 ownRadiance(ListedFace listed, uint id, vec3 albedo) {
    vec3 radiance = vec3(0.0);
#ifdef VCT_EMISSION
    radiance = unpackRgb9e5(faceData[faceAt(id) + VCT_FACE_EMITTED]);
#endif
    if (albedo == vec3(0.0)) return radiance;
    SurfacePlane plane = facePlane(id);
    FaceExtent extent = faceExtent(id);
    vec3 middle = surfaceMiddle(listed.voxel, listed.face, plane, extent);
    return radiance +
           albedo * directIrradiance(plane, slackShareOf(extent.isCurved), middle, cascadeOf(listed.voxel));
}

void main() {
    uint count = visitedFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(i);
        ListedFace listed = baseFace(id);
        // The sums of a merged dynamic face are added to a static face, which is injected with both.
        if (listed.isMerged) continue;
        vec3 albedo = unpackRgb9e5(faceData[faceAt(id) + VCT_FACE_REFLECTANCE]);
        vec3 own = ownRadiance(listed, id, albedo);
        faceIrradianceData[irradianceAt(id) + VCT_FACE_DIRECT] = packRgb9e5(own);
        vec3 irradiance = faceMean(id, VCT_MEAN_SHOWN).rgb + emitterIrradiance(id);
        faceData[radianceAt(id)] = packRgb9e5(own + reflectedBounces(albedo, irradiance));
    }
}
