// Render data: albedo and normal; the position comes from depth, the tangent frame from the normal.
#include "shared/counters.glsl"
#include "shared/material.glsl"
#include "shared/octahedral.glsl"

in vec3 fragmentNormal;

layout(location = 0) out vec4 albedoRoot;  // square root of linear albedo: spends the 8 bits where eyes look
layout(location = 1) out uvec2 normalCode;

#ifdef VCT_EMISSIVE_TARGET
layout(location = 2) out vec4 emissive;
void storeEmissive() {
    emissive = vec4(materialEmissive(), 1.0);
}
#else
void storeEmissive() {}
#endif

#ifdef VCT_GLOSS_TARGET
layout(location = VCT_GLOSS_TARGET) out vec2 gloss;  // metallic, roughness
void storeGloss() {
    gloss = draw.surface.yz;
}
#else
void storeGloss() {}
#endif

void main() {
    COUNT(VCT_COUNTER_G_BUFFER);
    vec4 baseColor = materialBaseColor();
    if (materialIsHole(baseColor.a)) discard;
    vec3 normal = safeNormalize(fragmentNormal);
    albedoRoot = vec4(sqrt(baseColor.rgb), 1.0);
    normalCode = encodeNormal(gl_FrontFacing ? normal : -normal);
    storeEmissive();
    storeGloss();
}
