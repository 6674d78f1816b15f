// Reflections of rough surfaces in half the resolution: a few rays in the lobe, for each block of 2 x 2
// pixels that shows a surface whose lobe is so wide that passes/gloss.frag can interpolate between
// neighbouring blocks. The other blocks are 0 (passes/gloss_mark.frag).
#include "passes/rough_pixel.glsl"
#include "passes/reflection.glsl"

layout(early_fragment_tests) in;
// rgb: light from around the mirror direction, relative to E/pi; a: 1 + the index of the pixel in the block.
layout(location = 0) out mediump vec4 outSample;

void main() {
    ivec2 block = ivec2(gl_FragCoord.xy);
    int index = roughPixel(block);
    ivec2 pixel = pixelOf(block, index);
    vec3 position = surfacePosition(vec2(pixel) + 0.5, surfaceDepth(pixel));
    mediump float roughness = texelFetch(glossTarget, pixel, 0).g;
    vec3 light = reflectedLight(position, shadingNormal(pixel), roughness, 8, turnOfPixel(block));
    outSample = vec4(light, float(index + 1));
}
