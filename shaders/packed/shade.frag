// The last pass of the thesis (4.6): computes the light of each pixel in one of the five modes (5.1.2), or a
// part of the light. With directional voxels it draws the modes 1 to 3, and passes/shade.frag the others.
// VCT_MODE is the output's number, and VCT_SHOWS_* are its inputs (jni/engine/output.h).
#include "shared/orthonormal.glsl"
#include "shared/shadow.glsl"
#include "shared/sky.glsl"
#include "shared/surface.glsl"
#include "passes/pixel_lights.glsl"

const int mode = VCT_MODE;

layout(binding = VCT_TEX_G_ALBEDO) uniform mediump sampler2D albedoTarget;

layout(location = 0) out mediump vec4 outRadiance;  // rgb relative to E/pi; a: 1 on a surface, 0 on the sky

// The constants of the thesis's published program. They have no physical meaning, and are used in modes 1 to
// 3 only.
const float ambientLight = 0.05;
const float specularLight = 0.2;
const float specularExponent = 5.0;
// i in eq. 4.9: the share of direct light that a shadow removes.
const float shadowStrength = 0.9;

struct Gather {
    mediump vec3 radiance;            // mean over the hemisphere, weighted by the cosine, relative to E/pi
    mediump float ambientVisibility;  // 1 - ambient occlusion
};

// With directional voxels, the mode 3 shows the ambient visibility that their faces gather, and a surface is
// compared with the shadow map by its plane in place of the bias of eq. 4.2.
#ifdef VCT_DIRECTIONAL_VOXELS
#include "directional/irradiance.glsl"
Gather indirectDiffuse(vec3 position, vec3 normal) {
    return Gather(vec3(0.0), VCT_SHOWS_AMBIENT_VISIBILITY ? ambientVisibilityAt(position, normal) : 1.0);
}
mediump float sunVisibility(vec3 position, SurfaceNormals normals, float cosTheta) {
    return shadowMapLightOn(position, normals.face, slackShareOf(normals.isCurved));
}
#else
#include "packed/cones.glsl"
Gather indirectDiffuse(vec3 position, vec3 normal) {
    const float diffuseReach = 1.0;  // in sides of the volume (published program)
    if (VCT_SHOWS_AMBIENT_VISIBILITY) return gatherDiffuse(position, normal, frame.aoDistance);
    if (VCT_SHOWS_INDIRECT_LIGHT) return gatherDiffuse(position, normal, diffuseReach);
    return Gather(vec3(0.0), 1.0);
}
mediump float sunVisibility(vec3 position, SurfaceNormals normals, float cosTheta) {
    return VCT_SHOWS_SOFT_SHADOW ? traceShadowCone(position, normals.geometric)
                                 : shadowMapLight(position, cosTheta);
}
#endif

// The share of the sun's light that reaches the surface, as far as the output shows shadows. The sun reaches
// only triangles that are turned to it, whatever their interpolated normals; shading needs both turned to it.
mediump float directLight(vec3 position, SurfaceNormals normals) {
    if (!VCT_SHOWS_SOFT_SHADOW && !VCT_SHOWS_HARD_SHADOW) return 1.0;
    float cosTheta = dot(normals.geometric, frame.directionToLight.xyz);
    if (min(cosTheta, dot(normals.face, frame.directionToLight.xyz)) <= 0.0) return 0.0;
    return sunVisibility(position, normals, cosTheta);
}

mediump float phongSpecular(vec3 position, vec3 normal, float cosTheta) {
    vec3 toEye = normalize(frame.eye.xyz - position);
    vec3 reflection = 2.0 * cosTheta * normal - frame.directionToLight.xyz;
    return cosTheta > 0.0 ? pow(max(dot(reflection, toEye), 0.0), specularExponent) : 0.0;
}

// The light of the sun and the indirect light that the surface reflects towards the eye, or the part of it
// that the output shows. `light`: result of directLight().
mediump vec3 shadeSunAndIndirect(mediump vec3 albedo, vec3 position, vec3 normal, mediump float light,
                                 Gather gather) {
    float cosTheta = max(dot(normal, frame.directionToLight.xyz), 0.0);
    if (mode == VCT_VIEW_AO) return vec3(gather.ambientVisibility);
    if (mode == VCT_VIEW_INDIRECT) return albedo * gather.radiance;
    if (mode == VCT_VIEW_IRRADIANCE) return gather.radiance;
    if (mode == VCT_VIEW_CONE_SHADOW) return vec3(light);
    if (mode == VCT_VIEW_SPECULAR) return vec3(0.0);
    // Eq. 4.9.
    mediump float total = mix(gather.ambientVisibility, light * gather.ambientVisibility, shadowStrength);
    if (VCT_SHOWS_INDIRECT_LIGHT)
        return albedo * (cosTheta * total * frame.lightColor.rgb + gather.radiance);  // eq. 4.10
    if (mode == VCT_MODE_PHONG) total = 1.0;
    mediump float phong = cosTheta + specularLight * phongSpecular(position, normal, cosTheta);
    return albedo * (ambientLight * frame.lightColor.a * gather.ambientVisibility +
                     phong * total * frame.lightColor.rgb);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = surfaceDepth(pixel);
    if (depth == frame.farDepth) {
        outRadiance = vec4(skyBehind(gl_FragCoord.xy), 0.0);
        return;
    }
    vec3 position = surfacePosition(gl_FragCoord.xy, depth);
    mediump vec4 albedo = texelFetch(albedoTarget, pixel, 0);
    SurfaceNormals normals = surfaceNormals(pixel, albedo.a);
    // The gather comes first because it needs the most registers, of which Mali GPUs have few.
    Gather gather = indirectDiffuse(position, normals.geometric);
    mediump float light = directLight(position, normals);
    Brdf brdf = Brdf(albedo.rgb * albedo.rgb);
    mediump vec3 radiance = shadeSunAndIndirect(brdf.diffuse, position, normals.shading, light, gather);
    outRadiance = vec4(radiance + shadePunctualLights(brdf, position, normals) + emitted(pixel), 1.0);
}
