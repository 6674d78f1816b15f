// The last pass: the light of each pixel, in the five modes (thesis 4.6, 5.1.2) or a part of it alone. One variant per
// VCT_MODE, one of VCT_MODE_* and VCT_VIEW_*.
#define VCT_CONE_COUNTER VCT_COUNTER_SPECULAR_STEP
#include "shared/counters.glsl"
#include "shared/orthonormal.glsl"
#include "shared/shadow.glsl"
#include "shared/sky.glsl"
#include "shared/surface.glsl"

const int mode = VCT_MODE;
const bool showsAmbientVisibility = mode == VCT_MODE_AO || mode == VCT_VIEW_AO;
const bool showsIndirectLight = mode >= VCT_MODE_GI && !showsAmbientVisibility && mode != VCT_VIEW_CONE_SHADOW;
const bool showsHardShadow = mode >= VCT_MODE_SHADOW_MAP && mode <= VCT_MODE_GI;
const bool showsSoftShadow = mode == VCT_MODE_GI_CONE_SHADOW || mode == VCT_VIEW_CONE_SHADOW;

layout(binding = VCT_TEX_G_ALBEDO) uniform mediump sampler2D albedoTarget;

layout(location = 0) out mediump vec4 outRadiance;  // rgb relative to E/pi; a: 1 on a surface, 0 on the sky

// From the published program; they are matters of taste and stand in modes 1 to 3 only.
const float ambientLight = 0.05;
const float specularLight = 0.2;
const float specularExponent = 5.0;
// i in eq. 4.9: the share of direct light that a shadow takes.
const float shadowStrength = 0.9;

struct Gather {
    mediump vec3 radiance;            // mean over the hemisphere, weighted by the cosine, relative to E/pi
    mediump float ambientVisibility;  // 1 - ambient occlusion
};

// What a surface gathers: by its pixel's own cones, or, with directional voxels, what its faces have received.
#ifdef VCT_RECEIVED
#include "directional/irradiance.glsl"
const bool received = true;
Gather indirectDiffuse(vec3 position, vec3 normal) {
    if (showsAmbientVisibility) return Gather(vec3(0.0), ambientVisibilityAt(position, normal));
    return Gather(receivedAt(position, normal), 1.0);
}
#else
#include "packed/cones.glsl"
const bool received = false;
Gather indirectDiffuse(vec3 position, vec3 normal) {
    const float diffuseReach = 1.0;  // in sides of the volume (published program)
    if (showsAmbientVisibility) return gatherDiffuse(position, normal, frame.aoDistance);
    if (showsIndirectLight) return gatherDiffuse(position, normal, diffuseReach);
    return Gather(vec3(0.0), 1.0);
}
#endif

// The share of a sun with a size that a surface sees: by the shadow map, or by a cone through packed voxels.
#if defined(VCT_SOFT_SHADOW)
#include "passes/soft_shadow.glsl"
const bool softShadowIsAll = true;
mediump float softSun(vec3 position, vec3 normal, float cosTheta) {
    return softShadow(position, normal);
}
#elif defined(VCT_RECEIVED)
const bool softShadowIsAll = false;
mediump float softSun(vec3 position, vec3 normal, float cosTheta) {
    return 1.0;
}
#else
const bool softShadowIsAll = false;
mediump float softSun(vec3 position, vec3 normal, float cosTheta) {
    return cosTheta > 0.0 ? traceShadowCone(position, normal) : 0.0;
}
#endif

// What the mode shows of the sun, of 1.
mediump float directLight(vec3 position, vec3 normal, float cosTheta) {
    if (showsSoftShadow) return softSun(position, normal, cosTheta);
    if (!showsHardShadow) return 1.0;
    if (received) return shadowMapLightOn(position, normal);
    return shadowMapLight(position, cosTheta);
}

// Lights besides the sun.
#ifdef VCT_PUNCTUAL_LIGHTS
#include "shared/punctual_lights.glsl"
// Irradiance of a surface by all of them, relative to the sun's E.
mediump vec3 otherLights(vec3 position, vec3 normal) {
    if (mode > VCT_MODE_GI_CONE_SHADOW) return vec3(0.0);
    if (mode != VCT_MODE_PHONG) return punctualIrradiance(position, normal);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < punctual.count.x; ++i) {
        LightAt light = lightAt(i, position);
        sum += light.irradiance * max(dot(normal, light.towards), 0.0);
    }
    return sum;
}
#else
mediump vec3 otherLights(vec3 position, vec3 normal) {
    return vec3(0.0);
}
#endif

struct Reflected {
    mediump vec3 light;         // specular, relative to E/pi
    mediump vec3 diffuseShare;  // of the albedo, that is left for diffuse light
};

// What a glossy surface reflects besides diffuse light. `light`: of the sun.
#ifdef VCT_GLOSS_TARGET
#include "passes/glossy.glsl"
#ifdef VCT_PUNCTUAL_LIGHTS
vec3 otherHighlights(vec3 f0, float roughness, vec3 position, vec3 normal, vec3 toEye) {
    float slackShare = shadowSlack(normal);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < punctual.count.x; ++i) {
        LightAt light = lightAt(i, position);
        vec3 reflected = highlight(f0, roughness, normal, toEye, light.towards) * light.irradiance;
        if (max(reflected.r, max(reflected.g, reflected.b)) < 1e-4) continue;  // seen in no picture
        sum += reflected * punctualVisibility(i, position, normal, light.towards, slackShare);
    }
    return min(sum, 6e4);
}
#else
vec3 otherHighlights(vec3 f0, float roughness, vec3 position, vec3 normal, vec3 toEye) {
    return vec3(0.0);
}
#endif
layout(binding = VCT_TEX_G_GLOSS) uniform mediump sampler2D glossTarget;  // metallic, roughness
Reflected specular(ivec2 pixel, vec3 position, vec3 normal, mediump vec3 albedo, mediump vec3 gathered, mediump float light) {
    mediump vec3 gloss = texelFetch(glossTarget, pixel, 0).rgb;
    if (gloss.y >= 1.0) return Reflected(vec3(0.0), vec3(1.0));
    vec3 toEye = normalize(frame.eye.xyz - position);
    mediump vec3 f0 = mix(vec3(0.04), albedo, gloss.x);
    mediump vec3 share = specularShare(f0, gloss.y, max(dot(normal, toEye), 0.0));
    mediump vec3 reflected = share * lightToReflect(position, normal, toEye, gloss.y, gathered);
    if (mode != VCT_VIEW_SPECULAR) {
        vec3 ofSun = highlight(f0, gloss.y, normal, toEye, frame.towardsLight.xyz) * frame.lightColor.rgb;
        reflected = reflected + light * ofSun + otherHighlights(f0, gloss.y, position, normal, toEye);
    }
    return Reflected(reflected, (1.0 - gloss.x) * (1.0 - share));
}
#else
Reflected specular(ivec2 pixel, vec3 position, vec3 normal, mediump vec3 albedo, mediump vec3 gathered, mediump float light) {
    return Reflected(vec3(0.0), vec3(1.0));
}
#endif

#ifdef VCT_EMISSIVE_TARGET
layout(binding = VCT_TEX_G_EMISSIVE) uniform mediump sampler2D emissiveTarget;
mediump vec3 emitted(ivec2 pixel) {
    return mode <= VCT_MODE_GI_CONE_SHADOW ? texelFetch(emissiveTarget, pixel, 0).rgb : vec3(0.0);
}
#else
mediump vec3 emitted(ivec2 pixel) {
    return vec3(0.0);
}
#endif

mediump float phongSpecular(vec3 position, vec3 normal, float cosTheta) {
    vec3 toEye = normalize(frame.eye.xyz - position);
    vec3 mirrored = 2.0 * cosTheta * normal - frame.towardsLight.xyz;
    return cosTheta > 0.0 ? pow(max(dot(mirrored, toEye), 0.0), specularExponent) : 0.0;
}

// Diffuse light that leaves the surface, or the part of the light that a view shows.
mediump vec3 diffuse(vec3 position, vec3 normal, float cosTheta, mediump vec3 albedo, Gather gather, mediump float light) {
    if (mode == VCT_VIEW_AO) return vec3(gather.ambientVisibility);
    if (mode == VCT_VIEW_INDIRECT) return albedo * gather.radiance;
    if (mode == VCT_VIEW_IRRADIANCE) return gather.radiance;
    if (mode == VCT_VIEW_CONE_SHADOW) return vec3(light);
    if (mode == VCT_VIEW_SPECULAR) return vec3(0.0);
    // Occlusion is in the received light already; it takes nothing from the sun.
    if (mode >= VCT_MODE_GI && received)
        return albedo * (cosTheta * light * frame.lightColor.rgb + gather.radiance);
    // What the sun's disc shows is the direct light; nothing else dims or lifts it. Else eq. 4.9.
    mediump float total = light;
    if (!softShadowIsAll)
        total = mix(gather.ambientVisibility, light * gather.ambientVisibility, shadowStrength);
    if (mode >= VCT_MODE_GI)
        return albedo * (cosTheta * total * frame.lightColor.rgb + gather.radiance);  // eq. 4.10
    if (mode == VCT_MODE_PHONG) total = 1.0;
    mediump float phong = cosTheta + specularLight * phongSpecular(position, normal, cosTheta);
    return albedo * (ambientLight * gather.ambientVisibility + phong * total * frame.lightColor.rgb);
}

void main() {
    COUNT(VCT_COUNTER_CONE_TRACER);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = surfaceDepth(pixel);
    if (depth == 1.0) {
        outRadiance = vec4(skyBehind(gl_FragCoord.xy), 0.0);
        return;
    }
    vec3 position = surfacePosition(gl_FragCoord.xy, depth);
    vec3 normal = surfaceNormal(pixel);
    float cosTheta = max(dot(normal, frame.towardsLight.xyz), 0.0);
    mediump vec3 root = texelFetch(albedoTarget, pixel, 0).rgb;
    mediump vec3 albedo = root * root;

    Gather gather = indirectDiffuse(position, normal);
    mediump float light = directLight(position, normal, cosTheta);
    Reflected reflected = specular(pixel, position, normal, albedo, gather.radiance, light);
    mediump vec3 diffuseAlbedo = albedo * reflected.diffuseShare;
    mediump vec3 radiance = diffuse(position, normal, cosTheta, diffuseAlbedo, gather, light);
    radiance = radiance + diffuseAlbedo * otherLights(position, normal);
    outRadiance = vec4(radiance + reflected.light + emitted(pixel), 1.0);
}
