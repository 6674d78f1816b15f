// The material of a fragment. Features that a material does not have cost nothing: VCT_BASE_COLOR_TEXTURE,
// VCT_EMISSIVE_TEXTURE, VCT_VERTEX_COLORS and VCT_UNLIT are defined only if it has them. VCT_ALPHA_MASK,
// VCT_EMISSIVE and VCT_DOUBLE_SIDED are true or false.
#include "shared/draw.glsl"

const bool materialHasHoles = VCT_ALPHA_MASK;
const bool materialEmits = VCT_EMISSIVE;
const bool materialIsDoubleSided = VCT_DOUBLE_SIDED;

#ifdef VCT_BASE_COLOR_TEXTURE
in vec2 fragmentUv;
layout(binding = VCT_TEX_BASE_COLOR) uniform sampler2D baseColorTexture;
vec4 baseColorFactor() {
    return texture(baseColorTexture, fragmentUv);
}
#else
vec4 baseColorFactor() {
    return vec4(1.0);
}
#endif

#ifdef VCT_EMISSIVE_TEXTURE
in vec2 fragmentEmissiveUv;
layout(binding = VCT_TEX_EMISSIVE) uniform sampler2D emissiveTexture;
vec3 emissiveFactor() {
    return texture(emissiveTexture, fragmentEmissiveUv).rgb;
}
#else
vec3 emissiveFactor() {
    return vec3(1.0);
}
#endif

#ifdef VCT_VERTEX_COLORS
in vec4 fragmentColor;
vec4 vertexColorFactor() {
    return fragmentColor;
}
#else
vec4 vertexColorFactor() {
    return vec4(1.0);
}
#endif

// An unlit surface shows its base colour. It neither receives light nor sends any to other surfaces.
#ifdef VCT_UNLIT
const bool materialIsUnlit = true;
#else
const bool materialIsUnlit = false;
#endif

// Linear RGB and alpha.
vec4 materialBaseColor() {
    return draw.baseColor * baseColorFactor() * vertexColorFactor();
}

// True if an alpha-masked surface has a hole here.
bool materialIsHole(float alpha) {
    return materialHasHoles && alpha < draw.surface.x;
}

// Emitted radiance relative to E/pi.
vec3 materialEmissive() {
    return materialEmits ? draw.emissive.rgb * emissiveFactor() : vec3(0.0);
}
