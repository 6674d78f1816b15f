// The surface under a fragment. VCT_BASE_COLOR_TEXTURE, VCT_ALPHA_MASK, VCT_EMISSIVE, VCT_EMISSIVE_TEXTURE
// and VCT_DOUBLE_SIDED are defined where the material has them: the rest costs nothing.
#include "shared/draw.glsl"

#ifdef VCT_BASE_COLOR_TEXTURE
layout(binding = VCT_TEX_BASE_COLOR) uniform sampler2D baseColorTexture;
#endif
#ifdef VCT_EMISSIVE_TEXTURE
layout(binding = VCT_TEX_EMISSIVE) uniform sampler2D emissiveTexture;
#endif

// Linear RGB and alpha.
vec4 materialBaseColor(vec2 uv) {
#ifdef VCT_BASE_COLOR_TEXTURE
    return draw.baseColor * texture(baseColorTexture, uv);
#else
    return draw.baseColor;
#endif
}

// Whether an alpha-masked surface has a hole here.
bool materialIsHole(float alpha) {
#ifdef VCT_ALPHA_MASK
    return alpha < draw.surface.x;
#else
    return false;
#endif
}

// Emitted radiance relative to E/pi.
vec3 materialEmissive(vec2 uv) {
#if defined(VCT_EMISSIVE_TEXTURE)
    return draw.emissive.rgb * texture(emissiveTexture, uv).rgb;
#elif defined(VCT_EMISSIVE)
    return draw.emissive.rgb;
#else
    return vec3(0.0);
#endif
}
