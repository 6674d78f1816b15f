// A level of the shadow map's moments (shared/moments.glsl) out of the finer one.
#include "shared/counters.glsl"
#include "shared/moments.glsl"

layout(binding = VCT_TEX_SHADOW_MOMENTS) uniform highp sampler2D finer;  // this level alone is readable

layout(location = 0) out vec2 outMoments;

void main() {
    COUNT(VCT_COUNTER_SHADOW_MOMENTS_NEXT);
    vec2 texel = 1.0 / vec2(textureSize(finer, 0));
    vec2 middle = 2.0 * floor(gl_FragCoord.xy) + 1.0;
    vec4 at = vec4(middle - 1.0, middle + 1.0) * texel.xyxy;
    vec2 ofMeans = momentsOf(textureGather(finer, at.xy), textureGather(finer, at.zy), textureGather(finer, at.xw),
                             textureGather(finer, at.zw));
    // The variance within the texels, as the linear filter weighs them: (1 3 3 1)/8 are two pairs, each 1:3.
    vec4 between = vec4(middle - 0.75, middle + 0.75) * texel.xyxy;
    float within = textureLod(finer, between.xy, 0.0).g + textureLod(finer, between.zy, 0.0).g +
                   textureLod(finer, between.xw, 0.0).g + textureLod(finer, between.zw, 0.0).g;
    outMoments = vec2(ofMeans.x, ofMeans.y + 0.25 * within);
}
