// Draws a level of the shadow map from the next finer one. Depths must not be averaged before they are
// compared, so each texel takes one of its four. Half of the four block where an edge is in their middle: the
// second nearest counts them as blocked, and the third as free. Levels take turns, because otherwise blockers
// would grow or shrink from level to level. Turns within a level would draw dashes along the edges.
#include "shared/layout.h"

layout(binding = VCT_TEX_SHADOW_DEPTH) uniform highp sampler2D finer;  // limited to the finer level
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;

void main() {
    vec4 four = textureGather(finer, 2.0 * gl_FragCoord.xy / vec2(textureSize(finer, 0)));
    vec2 nearer = min(four.xz, four.yw), farther = max(four.xz, four.yw);
    vec2 middle = vec2(max(nearer.x, nearer.y), min(farther.x, farther.y));
    gl_FragDepth = (level & 1u) == 0u ? min(middle.x, middle.y) : max(middle.x, middle.y);
}
