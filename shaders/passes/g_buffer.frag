// Render data: albedo and normal; the position comes from depth, the tangent frame from the normal.
#include "shared/material.glsl"
#include "shared/octahedral.glsl"
#include "shared/counters.glsl"

in vec3 fragmentNormal;
#ifdef VCT_BASE_COLOR_TEXTURE
in vec2 fragmentUv;
#else
const vec2 fragmentUv = vec2(0.0);
#endif
#ifdef VCT_EMISSIVE_TEXTURE
in vec2 fragmentEmissiveUv;
#else
const vec2 fragmentEmissiveUv = vec2(0.0);
#endif

layout(location = 0) out vec4 albedoRoot;  // square root of linear albedo: spends the 8 bits where eyes look
layout(location = 1) out uvec2 normalCode;
#ifdef VCT_EMISSIVE_TARGET
layout(location = 2) out vec4 emissive;
#endif
#ifdef VCT_GLOSS_TARGET
layout(location = VCT_GLOSS_TARGET) out vec2 gloss;  // metallic, roughness
#endif

void main() {
    COUNT(VCT_COUNTER_G_BUFFER);
    vec4 baseColor = materialBaseColor(fragmentUv);
    if (materialIsHole(baseColor.a)) discard;
    vec3 normal = safeNormalize(fragmentNormal);
    albedoRoot = vec4(sqrt(baseColor.rgb), 1.0);
    normalCode = encodeNormal(gl_FrontFacing ? normal : -normal);
#ifdef VCT_EMISSIVE_TARGET
    emissive = vec4(materialEmissive(fragmentEmissiveUv), 1.0);
#endif
#ifdef VCT_GLOSS_TARGET
    gloss = draw.surface.yz;
#endif
}
