// Reflections of rough surfaces in half the resolution: a few rays in the lobe, for each block of 2 x 2
// pixels that shows a surface whose lobe is so wide that neighbouring blocks can share their rays
// (passes/gloss_filter.frag). The other blocks are 0 (passes/gloss_mark.frag).
#include "passes/rough_pixel.glsl"
#include "passes/reflection.glsl"

layout(early_fragment_tests) in;
// rgb: mean light from around the mirror direction, relative to E/pi; a: 1 + the index of the pixel in the
// block + the weight of the mean, below 1.
layout(location = 0) out mediump vec4 outSample;

void main() {
    ivec2 block = ivec2(gl_FragCoord.xy);
    int index = roughPixel(block);
    RoughSurface surface = roughSurface(pixelOf(block, index));
    // There are 64 directions in 4 x 4 blocks. Wider solid angles overlap, so that what is small and bright
    // in the sky has no copies. They also take the sky below the horizon, which darkens metals.
    const float directions = 48.0;
    int place = sampleOf(block / surface.blockStep);
    vec4 light = reflectedLight(surface.position, surface.normal, surface.roughness, directions, place);
    outSample = vec4(min(light.rgb / max(light.a, 1e-4), 6e4), float(index + 1) + light.a);
}
