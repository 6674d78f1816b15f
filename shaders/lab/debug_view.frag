// Shows an intermediate target as an image; one variant per VCT_DEBUG_VIEW.
#include "shared/normals.glsl"
#include "shared/layout.h"

layout(binding = VCT_TEX_SHADOW_MAP) uniform sampler2D shadowMapDepth;
layout(binding = VCT_TEX_G_ALBEDO) uniform sampler2D albedoTarget;
layout(binding = VCT_TEX_G_NORMAL) uniform usampler2D normalTarget;
layout(binding = VCT_TEX_G_DEPTH) uniform sampler2D depthTarget;
layout(binding = VCT_TEX_G_EMISSIVE) uniform sampler2D emissiveTarget;
layout(location = 0) out vec4 outColor;

const int view = VCT_DEBUG_VIEW;

vec3 color(ivec2 pixel) {
    if (view == VCT_DEBUG_VIEW_SHADOW_MAP) return vec3(texelFetch(shadowMapDepth, pixel, 0).r);
    if (view == VCT_DEBUG_VIEW_DEPTH) return vec3(texelFetch(depthTarget, pixel, 0).r);
    if (view == VCT_DEBUG_VIEW_EMISSIVE) return texelFetch(emissiveTarget, pixel, 0).rgb;
    if (view == VCT_DEBUG_VIEW_ALBEDO) {
        vec3 root = texelFetch(albedoTarget, pixel, 0).rgb;
        return root * root;
    }
    bool surface = texelFetch(depthTarget, pixel, 0).r < 1.0;
    return surface ? decodeNormal(texelFetch(normalTarget, pixel, 0).rg) * 0.5 + 0.5 : vec3(0.0);
}

void main() {
    outColor = vec4(color(ivec2(gl_FragCoord.xy)), 1.0);
}
