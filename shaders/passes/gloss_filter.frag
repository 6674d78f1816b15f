// Averages the samples of passes/gloss_half.frag over seven of them along one axis, as far as they belong to
// the same surface; the two passes follow each other. The weights fall linearly, so that each of the set's
// directions has the same weight, and so has its place: around the middle, every gradient cancels.
#include "passes/rough_pixel.glsl"

layout(binding = VCT_TEX_HALF_GLOSS) uniform highp sampler2D halfGloss;
layout(location = VCT_UNIFORM_AXIS) uniform uint axis;

layout(location = 0) out mediump vec4 outMean;  // as in passes/gloss_half.frag

void main() {
    ivec2 block = ivec2(gl_FragCoord.xy), lastBlock = textureSize(halfGloss, 0) - 1;
    float index = floor(texelFetch(halfGloss, block, 0).a) - 1.0;
    // The samples of each side; -1: none, because the block has no rays.
    int reach = index < 0.0 ? -1 : 3;
    RoughSurface surface = roughSurface(pixelOf(block, max(int(index), 0)));
    ivec2 along = surface.blockStep * (axis == 0u ? ivec2(1, 0) : ivec2(0, 1));
    vec4 sum = vec4(0.0);
    for (int i = -reach; i <= reach; ++i) {
        ivec2 other = clamp(block + i * along, ivec2(0), lastBlock);
        vec4 found = texelFetch(halfGloss, other, 0);
        if (found.a < 1.0) continue;
        float weight = float(4 - abs(i)) * fract(found.a);
        weight *= likeness(surface, pixelOf(other, int(found.a) - 1));
        sum += weight * vec4(found.rgb, 1.0);
    }
    outMean = vec4(min(sum.rgb / max(sum.a, 1e-6), 6e4), max(index + 1.0, 0.0) + 0.0625 * sum.a);
}
