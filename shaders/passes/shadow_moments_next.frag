// Computes a level of the shadow map's moments (shared/moments.glsl) from the next finer one.
#include "shared/counters.glsl"
#include "shared/moments.glsl"

layout(binding = VCT_TEX_SHADOW_MOMENTS) uniform highp sampler2D finer;  // limited to the finer level

layout(location = 0) out vec2 outMoments;

void main() {
    COUNT(VCT_COUNTER_SHADOW_MOMENTS_NEXT);
    vec2 texel = 1.0 / vec2(textureSize(finer, 0));
    vec2 middle = 2.0 * gl_FragCoord.xy * texel;
    vec2 at = middle - texel;
    vec2 meanMoments =
        momentsOf(textureGather(finer, at), textureGatherOffset(finer, at, ivec2(2, 0)),
                  textureGatherOffset(finer, at, ivec2(0, 2)), textureGatherOffset(finer, at, ivec2(2, 2)));
    // The mean variance within the texels. The weights (1 3 3 1)/8 are two pairs of 1:3, which the linear
    // filter can fetch.
    vec4 pairs = vec4(middle - 0.75 * texel, middle + 0.75 * texel);
    float within = textureLod(finer, pairs.xy, 0.0).g + textureLod(finer, pairs.zy, 0.0).g +
                   textureLod(finer, pairs.xw, 0.0).g + textureLod(finer, pairs.zw, 0.0).g;
    outMoments = vec2(meanMoments.x, max(meanMoments.y, 0.0) + 0.25 * within);
}
