// The last pass with directional voxels: global illumination of each pixel, or a part of it. VCT_MODE is the
// output's number, and VCT_SHOWS_* are its inputs (jni/engine/output.h). packed/shade.frag is the thesis's.
#include "directional/irradiance.glsl"
#include "shared/orthonormal.glsl"
#include "shared/shadow.glsl"
#include "shared/sky.glsl"
#include "shared/surface.glsl"
#include "passes/pixel_lights.glsl"
#include "passes/soft_shadow.glsl"

const int mode = VCT_MODE;

layout(binding = VCT_TEX_G_ALBEDO) uniform mediump sampler2D albedoTarget;

layout(location = 0) out mediump vec4 outRadiance;  // rgb relative to E/pi; a: 1 on a surface, 0 on the sky

// The share of the sun's light that reaches the surface, as far as the output shows shadows. The sun reaches
// only triangles that are turned to it, whatever their interpolated normals; shading needs both turned to it.
mediump float directLight(vec3 position, SurfaceNormals normals) {
    if (!VCT_SHOWS_SOFT_SHADOW && !VCT_SHOWS_HARD_SHADOW) return 1.0;
    vec3 toSun = frame.directionToLight.xyz;
    if (min(dot(normals.geometric, toSun), dot(normals.face, toSun)) <= 0.0) return 0.0;
    float slackShare = slackShareOf(normals.isCurved);
    if (VCT_SHOWS_SOFT_SHADOW) return softShadow(position, normals.face, slackShare);
    return shadowMapLightOn(position, normals.face, slackShare);
}

#ifdef VCT_GLOSS_TARGET
layout(binding = VCT_TEX_G_GLOSS) uniform mediump sampler2D glossTarget;  // metallic, roughness
Brdf brdfAt(ivec2 pixel, vec3 position, mediump vec3 albedo) {
    mediump vec2 gloss = texelFetch(glossTarget, pixel, 0).rg;
    return brdfOf(albedo, gloss.x, gloss.y, normalize(frame.eye.xyz - position));
}
// The part of the indirect specular light that rough surfaces take from face irradiance. passes/gloss.frag
// adds the rays' part.
mediump vec3 roughReflection(Brdf brdf, vec3 normal, mediump vec3 gathered) {
    return (1.0 - brdf.lobeShare) * specularShare(brdf, normal) * gathered;
}
// passes/gloss.frag is drawn at the depth 0.5 and only where the depth is larger.
void markLobe(bool hasLobe) {
    gl_FragDepth = hasLobe ? 1.0 : 0.0;
}
#else
bool hasLobe(Brdf brdf) {
    return false;
}
Brdf brdfAt(ivec2 pixel, vec3 position, mediump vec3 albedo) {
    return Brdf(albedo);
}
mediump vec3 diffuseAlbedoScale(Brdf brdf, vec3 normal) {
    return vec3(1.0);
}
mediump vec3 roughReflection(Brdf brdf, vec3 normal, mediump vec3 gathered) {
    return vec3(0.0);
}
void markLobe(bool hasLobe) {}
#endif

// The light of the sun and the indirect light that the surface reflects towards the eye, or the part of it
// that the output shows. `light`: result of directLight(). `gathered`: irradiance, or ambient visibility.
mediump vec3 shadeSunAndIndirect(Brdf brdf, vec3 normal, mediump float light, mediump vec3 gathered) {
    if (mode == VCT_VIEW_AO || mode == VCT_VIEW_IRRADIANCE) return gathered;
    if (mode == VCT_VIEW_INDIRECT) return brdf.diffuse * gathered;
    if (mode == VCT_VIEW_CONE_SHADOW) return vec3(light);
    if (mode == VCT_VIEW_SPECULAR) return roughReflection(brdf, normal, gathered);
    return light * evaluateBrdf(brdf, normal, frame.directionToLight.xyz) * frame.lightColor.rgb +
           brdf.diffuse * diffuseAlbedoScale(brdf, normal) * gathered +
           roughReflection(brdf, normal, gathered);
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
    // The look-up comes first because it needs the most registers, of which Mali GPUs have few.
    mediump vec3 gathered = vec3(0.0);
    if (VCT_SHOWS_AMBIENT_VISIBILITY) gathered = vec3(ambientVisibilityAt(position, normals.geometric));
    if (VCT_SHOWS_INDIRECT_LIGHT) gathered = sampleIrradiance(position, normals.geometric);
    mediump float light = directLight(position, normals);
    Brdf brdf = brdfAt(pixel, position, albedo.rgb * albedo.rgb);
    markLobe(hasLobe(brdf));
    mediump vec3 radiance = shadeSunAndIndirect(brdf, normals.shading, light, gathered);
    outRadiance = vec4(radiance + shadePunctualLights(brdf, position, normals) + emitted(pixel), 1.0);
}
