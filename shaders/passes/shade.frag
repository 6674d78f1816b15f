// The last pass: what each pixel's cones see, and the five modes (thesis 4.6, 5.1.2). One variant per VCT_MODE.
#define VCT_CONE_COUNTER VCT_COUNTER_SPECULAR_STEP
#include "shared/counters.glsl"
#include "shared/surface.glsl"
#ifdef VCT_RECEIVED
#include "directional/irradiance.glsl"
struct Gather {
    mediump vec3 radiance;   // relative to E/pi
    mediump float ambientVisibility;  // 1 - ambient occlusion
};
#else
#include "packed/cones.glsl"
#endif
#include "shared/shadow.glsl"
#ifdef VCT_SOFT_SHADOW
#include "passes/soft_shadow.glsl"
#endif
#ifdef VCT_GLOSS_TARGET
#include "passes/glossy.glsl"
#endif

layout(binding = VCT_TEX_G_ALBEDO) uniform mediump sampler2D albedoTarget;
#ifdef VCT_EMISSIVE_TARGET
layout(binding = VCT_TEX_G_EMISSIVE) uniform mediump sampler2D emissiveTarget;
#endif
#ifdef VCT_GLOSS_TARGET
layout(binding = VCT_TEX_G_GLOSS) uniform mediump sampler2D glossTarget;  // metallic, roughness
#endif

layout(location = 0) out mediump vec4 outRadiance;  // rgb relative to E/pi; a: 1 on a surface, 0 on the sky

// From the published program; they are matters of taste and stand in modes 1 to 3 only.
const float ambientLight = 0.05;
const float specularLight = 0.2;
const float specularExponent = 5.0;
// i in eq. 4.9: the share of direct light that a shadow takes.
const float shadowStrength = 0.9;

// Diffuse cones end at one side of the volume (published program).
const float diffuseReach = 1.0;

mediump float phongSpecular(vec3 position, vec3 normal, float cosTheta) {
    vec3 toEye = normalize(frame.eye.xyz - position);
    vec3 mirrored = 2.0 * cosTheta * normal - frame.towardsLight.xyz;
    return cosTheta > 0.0 ? pow(max(dot(mirrored, toEye), 0.0), specularExponent) : 0.0;
}

void main() {
    COUNT(VCT_COUNTER_CONE_TRACER);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = surfaceDepth(pixel);
    if (depth == 1.0) {
        outRadiance = vec4(frame.skyRadiance.rgb, 0.0);
        return;
    }
    vec3 position = surfacePosition(gl_FragCoord.xy, depth);
    vec3 normal = surfaceNormal(pixel);
    float cosTheta = max(dot(normal, frame.towardsLight.xyz), 0.0);

#if defined(VCT_RECEIVED) && (VCT_MODE == VCT_MODE_AO || VCT_MODE == VCT_VIEW_AO)
    Gather gather = Gather(vec3(0.0), ambientVisibilityAt(position, normal));
#elif defined(VCT_RECEIVED)
    Gather gather = Gather(receivedAt(position, normal), 1.0);
#elif VCT_MODE == VCT_MODE_AO || VCT_MODE == VCT_VIEW_AO
    Gather gather = gatherDiffuse(position, normal, frame.cone.y);
#elif VCT_MODE == VCT_MODE_GI || VCT_MODE == VCT_MODE_GI_CONE_SHADOW || VCT_MODE == VCT_VIEW_INDIRECT
    Gather gather = gatherDiffuse(position, normal, diffuseReach);
#else
    Gather gather = Gather(vec3(0.0), 1.0);
#endif

    mediump float light = 1.0;
#if VCT_MODE == VCT_MODE_GI_CONE_SHADOW || VCT_MODE == VCT_VIEW_CONE_SHADOW
#ifdef VCT_SOFT_SHADOW
    light = softShadow(position, normal);
#else
    light = cosTheta > 0.0 ? traceShadowCone(position, normal) : 0.0;
#endif
#elif VCT_MODE >= VCT_MODE_SHADOW_MAP && VCT_MODE <= VCT_MODE_GI
#ifdef VCT_RECEIVED
    light = shadowMapLightOn(position, normal);
#else
    light = shadowMapLight(position, cosTheta);
#endif
#endif

    mediump vec3 root = texelFetch(albedoTarget, pixel, 0).rgb;
    mediump vec3 albedo = root * root;
#ifdef VCT_SOFT_SHADOW
    mediump float total = light;  // what the sun's disc shows is the direct light; nothing else dims or lifts it
#else
    // Eq. 4.9.
    mediump float total = mix(gather.ambientVisibility, light * gather.ambientVisibility, shadowStrength);
#endif
    mediump vec3 radiance;
#ifdef VCT_GLOSS_TARGET
    mediump vec3 specular = vec3(0.0);
    mediump vec3 gloss = texelFetch(glossTarget, pixel, 0).rgb;
    if (gloss.y < 1.0) {
        vec3 toEye = normalize(frame.eye.xyz - position);
        mediump vec3 f0 = mix(vec3(0.04), albedo, gloss.x);
        mediump vec3 share = specularShare(f0, gloss.y, max(dot(normal, toEye), 0.0));
        specular = share * lightToReflect(position, normal, toEye, gloss.y, gather.radiance);
#if VCT_MODE != VCT_VIEW_SPECULAR
        specular = specular + light * sunHighlight(f0, gloss.y, normal, toEye);
#endif
        albedo = albedo * (1.0 - gloss.x) * (1.0 - share);
    }
#endif
#if VCT_MODE == VCT_VIEW_AO
    radiance = vec3(gather.ambientVisibility);
#elif VCT_MODE == VCT_VIEW_INDIRECT
    radiance = albedo * gather.radiance;
#elif VCT_MODE == VCT_VIEW_CONE_SHADOW
    radiance = vec3(light);
#elif VCT_MODE == VCT_VIEW_SPECULAR
    radiance = vec3(0.0);
#elif VCT_MODE >= VCT_MODE_GI && defined(VCT_RECEIVED)
    // Occlusion is in the gathered light already; it takes nothing from the sun.
    radiance = albedo * (cosTheta * light * frame.lightColor.rgb + gather.radiance);
#elif VCT_MODE >= VCT_MODE_GI
    radiance = albedo * (cosTheta * total * frame.lightColor.rgb + gather.radiance);  // eq. 4.10
#else
#if VCT_MODE == VCT_MODE_PHONG
    total = 1.0;
#endif
    mediump float shade = cosTheta + specularLight * phongSpecular(position, normal, cosTheta);
    radiance = albedo * (ambientLight * gather.ambientVisibility + shade * total * frame.lightColor.rgb);
#endif
#ifdef VCT_GLOSS_TARGET
    radiance = radiance + specular;
#endif
#if defined(VCT_EMISSIVE_TARGET) && VCT_MODE <= VCT_MODE_GI_CONE_SHADOW
    radiance = radiance + texelFetch(emissiveTarget, pixel, 0).rgb;
#endif
    outRadiance = vec4(radiance, 1.0);
}
