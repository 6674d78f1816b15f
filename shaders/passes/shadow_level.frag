// A coarser level of the shadow map, for comparisons that stand for more than a texel (passes/soft_shadow.glsl). A texel has
// the depth of one place in it, not a mean, which would be of no surface, nor the nearest, which would widen what blocks. The
// places differ from texel to texel, by the golden section and another irrational number: a few texels along an edge
// together know where it is, whatever its direction.
#include "shared/counters.glsl"

layout(binding = VCT_TEX_SHADOW_DEPTH) uniform highp sampler2D finest;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;

void main() {
    COUNT(VCT_COUNTER_SHADOW_LEVEL);
    vec2 texel = floor(gl_FragCoord.xy);
    const mat2 apart = mat2(0.3247180, 0.6180340, 0.6180340, 0.4142136);
    int size = textureSize(finest, 0).x;  // the map is a square; of any size, also one that levels do not halve
    vec2 place = (texel + fract(apart * texel)) * (float(size) / float(size >> level));
    gl_FragDepth = texelFetch(finest, ivec2(place), 0).r;
}
