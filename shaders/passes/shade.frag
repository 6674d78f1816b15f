// The last pass: computes the light of each pixel in one of the five modes (thesis 4.6, 5.1.2), or a part of
// the light. Each output has a variant: VCT_MODE is its number, and VCT_SHOWS_* are its inputs
// (jni/engine/output.h).
#include "shared/orthonormal.glsl"
#include "shared/shadow.glsl"
#include "shared/sky.glsl"
#include "shared/surface.glsl"
#include "passes/penumbra.glsl"

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

// Indirect light of a surface: from the irradiance of directional voxels, or by cones of the pixel itself.
#ifdef VCT_FACE_IRRADIANCE
#include "directional/irradiance.glsl"
const bool received = true;
Gather indirectDiffuse(vec3 position, vec3 normal) {
    if (VCT_SHOWS_AMBIENT_VISIBILITY) return Gather(vec3(0.0), ambientVisibilityAt(position, normal));
    return Gather(sampleIrradiance(position, normal), 1.0);
}
#else
#include "packed/cones.glsl"
const bool received = false;
Gather indirectDiffuse(vec3 position, vec3 normal) {
    const float diffuseReach = 1.0;  // in sides of the volume (published program)
    if (VCT_SHOWS_AMBIENT_VISIBILITY) return gatherDiffuse(position, normal, frame.aoDistance);
    if (VCT_SHOWS_INDIRECT_LIGHT) return gatherDiffuse(position, normal, diffuseReach);
    return Gather(vec3(0.0), 1.0);
}
#endif

// The visible share of the sun's disc: by the soft shadow map, or by a cone through packed voxels.
#if defined(VCT_SOFT_SHADOW)
#include "passes/soft_shadow.glsl"
const bool softShadowIsAll = true;
mediump float softSun(vec3 position, SurfaceNormals normals) {
    return softShadow(position, normals.face, slackShareOf(normals.isCurved));
}
#elif defined(VCT_FACE_IRRADIANCE)
const bool softShadowIsAll = false;
mediump float softSun(vec3 position, SurfaceNormals normals) {
    return 1.0;
}
#else
const bool softShadowIsAll = false;
mediump float softSun(vec3 position, SurfaceNormals normals) {
    return traceShadowCone(position, normals.geometric);
}
#endif

// The share of the sun's light that reaches the surface, as far as the output shows shadows. The sun reaches
// only triangles that are turned to it, whatever their interpolated normals; shading needs both turned to it.
mediump float directLight(vec3 position, SurfaceNormals normals) {
    if (!VCT_SHOWS_SOFT_SHADOW && !VCT_SHOWS_HARD_SHADOW) return 1.0;
    float cosTheta = dot(normals.geometric, frame.directionToLight.xyz);
    if (min(cosTheta, dot(normals.face, frame.directionToLight.xyz)) <= 0.0) return 0.0;
    if (VCT_SHOWS_SOFT_SHADOW) return softSun(position, normals);
    if (VCT_PLANE_SHADOW) return shadowMapLightOn(position, normals.face, slackShareOf(normals.isCurved));
    return shadowMapLight(position, cosTheta);
}

// The surface's reflection towards the eye: glossy if the scene has glossy materials, else Lambertian.
#ifdef VCT_GLOSS_TARGET
#include "passes/glossy.glsl"
layout(binding = VCT_TEX_G_GLOSS) uniform mediump sampler2D glossTarget;  // metallic, roughness
Brdf brdfAt(ivec2 pixel, vec3 position, mediump vec3 albedo) {
    mediump vec2 gloss = texelFetch(glossTarget, pixel, 0).rg;
    return brdfOf(albedo, gloss.x, gloss.y, normalize(frame.eye.xyz - position));
}
// The part of the indirect specular light that rough surfaces take from face irradiance. passes/gloss.frag
// adds the cone's part.
mediump vec3 roughReflection(Brdf brdf, vec3 normal, mediump vec3 gathered) {
    return (1.0 - brdf.lobeShare) * specularShare(brdf, normal) * gathered;
}
// passes/gloss.frag is drawn at the depth 0.5 and only where the depth is larger.
void markLobe(bool hasLobe) {
    gl_FragDepth = hasLobe ? 1.0 : 0.0;
}
#else
struct Brdf {
    mediump vec3 diffuse;
};
bool hasLobe(Brdf brdf) {
    return false;
}
Brdf brdfAt(ivec2 pixel, vec3 position, mediump vec3 albedo) {
    return Brdf(albedo);
}
mediump vec3 evaluateBrdf(Brdf brdf, vec3 normal, vec3 toLight) {
    return brdf.diffuse * max(dot(normal, toLight), 0.0);
}
mediump vec3 diffuseAlbedoScale(Brdf brdf, vec3 normal) {
    return vec3(1.0);
}
mediump vec3 roughReflection(Brdf brdf, vec3 normal, mediump vec3 gathered) {
    return vec3(0.0);
}
void markLobe(bool hasLobe) {}
#endif

#ifdef VCT_PUNCTUAL_LIGHTS
#include "shared/punctual_lights.glsl"
// The light of the punctual lights that the surface reflects towards the eye, relative to the sun's E/pi.
mediump vec3 shadePunctualLights(Brdf brdf, vec3 position, SurfaceNormals normals) {
    float slackShare = slackShareOf(normals.isCurved);
    vec3 sum = vec3(0.0);
    const bool shadows = VCT_SHOWS_HARD_SHADOW || VCT_SHOWS_SOFT_SHADOW;
    for (int i = 0; i < punctual.count.x; ++i) {
        LightAt light = lightAt(i, position);
        vec3 left = evaluateBrdf(brdf, normals.shading, light.towards) * light.irradiance;
        if (left == vec3(0.0)) continue;
        sum +=
            shadows ? left * punctualVisibility(i, position, normals.face, light.towards, slackShare) : left;
    }
    return min(sum, 6e4);
}
#else
mediump vec3 shadePunctualLights(Brdf brdf, vec3 position, SurfaceNormals normals) {
    return vec3(0.0);
}
#endif

#ifdef VCT_EMISSIVE_TARGET
layout(binding = VCT_TEX_G_EMISSIVE) uniform mediump sampler2D emissiveTarget;
mediump vec3 emitted(ivec2 pixel) {
    return texelFetch(emissiveTarget, pixel, 0).rgb;
}
#else
mediump vec3 emitted(ivec2 pixel) {
    return vec3(0.0);
}
#endif

mediump float phongSpecular(vec3 position, vec3 normal, float cosTheta) {
    vec3 toEye = normalize(frame.eye.xyz - position);
    vec3 reflection = 2.0 * cosTheta * normal - frame.directionToLight.xyz;
    return cosTheta > 0.0 ? pow(max(dot(reflection, toEye), 0.0), specularExponent) : 0.0;
}

// The light of the sun and the indirect light that the surface reflects towards the eye, or the part of it
// that the output shows. `light`: result of directLight().
mediump vec3 shadeSunAndIndirect(Brdf brdf, vec3 position, vec3 normal, float cosTheta, mediump float light,
                                 Gather gather) {
    if (mode == VCT_VIEW_AO) return vec3(gather.ambientVisibility);
    if (mode == VCT_VIEW_INDIRECT) return brdf.diffuse * gather.radiance;
    if (mode == VCT_VIEW_IRRADIANCE) return gather.radiance;
    if (mode == VCT_VIEW_CONE_SHADOW) return vec3(light);
    if (mode == VCT_VIEW_SPECULAR) return roughReflection(brdf, normal, gather.radiance);
    // Face irradiance includes occlusion, which must not dim the sun.
    if (VCT_SHOWS_INDIRECT_LIGHT && received)
        return light * evaluateBrdf(brdf, normal, frame.directionToLight.xyz) * frame.lightColor.rgb +
               brdf.diffuse * diffuseAlbedoScale(brdf, normal) * gather.radiance +
               roughReflection(brdf, normal, gather.radiance);
    // The soft shadow is the exact share of the direct light. Other shadows are combined by eq. 4.9.
    mediump float total = light;
    if (!softShadowIsAll)
        total = mix(gather.ambientVisibility, light * gather.ambientVisibility, shadowStrength);
    if (VCT_SHOWS_INDIRECT_LIGHT)
        return brdf.diffuse * (cosTheta * total * frame.lightColor.rgb + gather.radiance);  // eq. 4.10
    if (mode == VCT_MODE_PHONG) total = 1.0;
    mediump float phong = cosTheta + specularLight * phongSpecular(position, normal, cosTheta);
    return brdf.diffuse * (ambientLight * frame.lightColor.a * gather.ambientVisibility +
                           phong * total * frame.lightColor.rgb);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = surfaceDepth(pixel);
    if (depth == frame.farDepth) {
        outRadiance = vec4(skyBehind(gl_FragCoord.xy), 0.0);
        markLobe(false);
        return;
    }
    vec3 position = surfacePosition(gl_FragCoord.xy, depth);
    mediump vec4 albedo = texelFetch(albedoTarget, pixel, 0);
    SurfaceNormals normals = surfaceNormals(pixel, albedo.a);
    float cosTheta = max(dot(normals.shading, frame.directionToLight.xyz), 0.0);
    // The gather comes first because it needs the most registers, of which Mali GPUs have few.
    Gather gather = indirectDiffuse(position, normals.geometric);
    mediump float light = directLight(position, normals);
    Brdf brdf = brdfAt(pixel, position, albedo.rgb * albedo.rgb);
    markLobe(hasLobe(brdf));
    mediump vec3 radiance = shadeSunAndIndirect(brdf, position, normals.shading, cosTheta, light, gather);
    outRadiance = vec4(radiance + shadePunctualLights(brdf, position, normals) + emitted(pixel), 1.0);
}
