// Writes one packed voxel per fragment: material and direct light (thesis 4.4). imageAtomicMax() keeps the
// largest word, so the order of fragments affects only the order of the active-voxel list.
#include "shared/commands.glsl"
#include "shared/material.glsl"
#include "shared/normals.glsl"
#include "shared/shadow.glsl"

#ifdef VCT_PUNCTUAL_LIGHTS
#include "shared/face_normal.glsl"
#include "shared/punctual_lights.glsl"
// Irradiance by the punctual lights. A double-sided surface takes the side that receives more.
vec3 otherLights(vec3 position, vec3 normal) {
    float slackShare = slackShareOf(dot(normal, faceNormal(position, normal)) < 0.9999);
    vec3 front = punctualIrradiance(position, normal, slackShare);
    return materialIsDoubleSided ? max(front, punctualIrradiance(position, -normal, slackShare)) : front;
}
#else
vec3 otherLights(vec3 position, vec3 normal) {
    return vec3(0.0);
}
#endif

in vec3 fragmentPosition;
in vec3 fragmentNormal;

layout(r32ui, binding = VCT_IMAGE_VOXELS) uniform uimage3D voxels;

void main() {
    vec4 baseColor = materialBaseColor();
    if (materialIsUnlit) baseColor.rgb = vec3(0.0);
    if (materialIsHole(baseColor.a)) discard;
    ivec3 voxel =
        clamp(ivec3(floor(fragmentPosition * float(frame.gridSide))), ivec3(0), ivec3(frame.gridSide - 1));

    // A single-sided surface is black from behind; a double-sided one is lit on the side that faces the
    // light.
    vec3 normal = safeNormalize(fragmentNormal);
    float facing = dot(normal, frame.directionToLight.xyz);
    float cosTheta = materialIsDoubleSided ? abs(facing) : max(facing, 0.0);
    bool lit = shadowMapLight(fragmentPosition, cosTheta) >= 0.5;
    vec3 radiance = cosTheta * baseColor.rgb * frame.lightColor.rgb;  // thesis eq. 4.4
    vec3 more = materialEmissive() + baseColor.rgb * otherLights(fragmentPosition, normal);
    if (more != vec3(0.0)) {
        radiance = more + (lit ? radiance : vec3(0.0));
        lit = true;
    }

    uvec3 color = uvec3(clamp(radiance, 0.0, 1.0) * float(VCT_BASE_COUNT * VCT_COLOR_STEPS) + 0.5);
    uint word = packVoxel(lit ? VCT_BASE_COUNT : 0u, VCT_BASE_COUNT, color);
    if (imageAtomicMax(voxels, voxel, word) == 0u) appendVoxel(0u, uvec3(voxel));
}
