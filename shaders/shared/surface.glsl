// The surface under a pixel, from the G-buffer.
#include "shared/blocks.glsl"
#include "shared/octahedral.glsl"

layout(binding = VCT_TEX_G_NORMAL) uniform usampler2D normalTarget;
layout(binding = VCT_TEX_G_DEPTH) uniform sampler2D depthTarget;

float surfaceDepth(ivec2 pixel) {
    return texelFetch(depthTarget, pixel, 0).r;
}

// Volume space.
vec3 surfacePosition(ivec2 pixel, float depth) {
    vec2 ndc = (vec2(pixel) + 0.5) / vec2(textureSize(depthTarget, 0)) * 2.0 - 1.0;
    vec4 p = frame.volumeFromClip * vec4(ndc, depth * 2.0 - 1.0, 1.0);
    return p.xyz / p.w;
}

vec3 surfaceNormal(ivec2 pixel) {
    return decodeNormal(texelFetch(normalTarget, pixel, 0).rg);
}
