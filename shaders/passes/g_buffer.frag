// Writes the G-buffer: albedo and normal, and emission and gloss if the scene has them. The position follows
// from the depth buffer.
#include "shared/material.glsl"
#include "shared/face_normal.glsl"
#include "shared/normals.glsl"

in vec3 fragmentNormal;
in vec3 fragmentFromEye;

// rgb: square root of linear albedo, which gives dark colours more steps; a: bits of encodeNormals().
layout(location = 0) out vec4 albedoRoot;
#ifdef VCT_MAPPED_NORMALS
layout(location = 1) out uvec4 normalCodes;
void storeNormals(uvec2 geometric, vec3 mapped) {
    normalCodes = uvec4(geometric, encodeOctahedral(mapped));
}
#else
layout(location = 1) out uvec2 normalCode;
void storeNormals(uvec2 geometric, vec3 mapped) {
    normalCode = geometric;
}
#endif

#ifdef VCT_EMISSIVE_TARGET
layout(location = 2) out vec4 emissive;
void storeEmissive() {
    emissive = vec4(materialIsUnlit ? materialBaseColor().rgb : materialEmissive(), 1.0);
}
#else
void storeEmissive() {}
#endif

#ifdef VCT_GLOSS_TEXTURE
in vec2 fragmentGlossUv;
layout(binding = VCT_TEX_GLOSS) uniform sampler2D glossTexture;
vec2 glossFactor() {
    return texture(glossTexture, fragmentGlossUv).bg;
}
#else
vec2 glossFactor() {
    return vec2(1.0);
}
#endif

#ifdef VCT_GLOSS_TARGET
layout(location = VCT_GLOSS_TARGET) out vec2 gloss;  // metallic, roughness
void storeGloss() {
    gloss = draw.surface.yz * glossFactor();
}
#else
void storeGloss() {}
#endif

// The normal of the normal map. `normal`: interpolated, towards the viewer, unit length. The tangent is
// derived from the screen-space derivatives of position and texture coordinates, because stored tangents
// would take 16 bytes per vertex.
#ifdef VCT_NORMAL_MAP
in vec2 fragmentNormalUv;
layout(binding = VCT_TEX_NORMAL_MAP) uniform sampler2D normalMap;
vec3 mappedNormal(vec3 normal) {
    vec3 mapped = 2.0 * texture(normalMap, fragmentNormalUv).xyz - 1.0;
    vec2 slope = mapped.xy * draw.emissive.w;
    // The normal of a back face is the reversed normal of the front face (glTF 2.0, 3.9.5).
    if (!gl_FrontFacing) slope = -slope;
    vec2 uvAcross = dFdx(fragmentNormalUv), uvUp = dFdy(fragmentNormalUv);
    float handedness = uvAcross.x * uvUp.y - uvAcross.y * uvUp.x < 0.0 ? -1.0 : 1.0;
    vec3 tangent = handedness * (dFdx(fragmentFromEye) * uvUp.y - dFdy(fragmentFromEye) * uvAcross.y);
    tangent -= normal * dot(normal, tangent);
    float length2 = dot(tangent, tangent);
    if (!(length2 > 0.0)) return normal;  // the texture coordinates are constant
    tangent *= inversesqrt(length2);
    // The map's +Y is up in its image, and the second texture coordinate grows downwards.
    vec3 up = handedness * cross(tangent, normal);
    return safeNormalize(tangent * slope.x + up * slope.y + normal * mapped.z);
}
#else
vec3 mappedNormal(vec3 normal) {
    return normal;
}
#endif

void main() {
    vec4 baseColor = materialBaseColor();
    vec3 normal = safeNormalize(fragmentNormal);
    if (!gl_FrontFacing) normal = -normal;
    // Both come before any discard, because derivatives need the whole quad.
    vec3 mapped = mappedNormal(normal);
    uvec3 codes = encodeNormals(normal, faceNormal(fragmentFromEye, -fragmentFromEye));
    if (materialIsHole(baseColor.a)) discard;
    albedoRoot = vec4(materialIsUnlit ? vec3(0.0) : sqrt(baseColor.rgb), float(codes.z) / 255.0);
    storeNormals(codes.xy, mapped);
    storeEmissive();
    storeGloss();
}
