// Averages the samples of passes/gloss_half.frag over the 4 x 4 blocks around each, as far as they belong to
// the same surface. Together they have a whole set of directions. The window is centred on the block, so half
// of it is in the blocks at either end.
#include "passes/rough_pixel.glsl"

layout(binding = VCT_TEX_HALF_GLOSS) uniform highp sampler2D halfGloss;

layout(early_fragment_tests) in;
// rgb: mean light from around the mirror direction, relative to E/pi; a: 1 + the index of the pixel in the
// block.
layout(location = 0) out mediump vec4 outMean;

void main() {
    ivec2 block = ivec2(gl_FragCoord.xy), lastBlock = textureSize(halfGloss, 0) - 1;
    float index = floor(texelFetch(halfGloss, block, 0).a) - 1.0;
    RoughSurface surface = roughSurface(pixelOf(block, int(index)));
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 25; ++i) {
        ivec2 offset = ivec2(i % 5, i / 5) - 2, other = clamp(block + offset, ivec2(0), lastBlock);
        vec4 found = texelFetch(halfGloss, other, 0);
        vec2 share = mix(vec2(1.0), vec2(0.5), equal(abs(offset), ivec2(2)));
        if (found.a >= 1.0 && isOn(surface, pixelOf(other, int(found.a) - 1)))
            sum += share.x * share.y * vec4(found.rgb, fract(found.a));
    }
    outMean = vec4(min(sum.rgb / max(sum.a, 1e-4), 6e4), index + 1.0);
}
