// The pixel that stands for a block of 2 x 2 pixels in passes/gloss_half.frag.
#include "shared/surface.glsl"
#include "passes/glossy.glsl"

layout(binding = VCT_TEX_G_GLOSS) uniform mediump sampler2D glossTarget;  // metallic, roughness

ivec2 pixelOf(ivec2 block, int index) {
    return min(2 * block + ivec2(index & 1, index >> 1), textureSize(glossTarget, 0) - 1);
}

// The index of the block's first pixel with a surface so rough that half the resolution is enough; -1 if
// there is none.
int roughPixel(ivec2 block) {
    mediump vec4 roughness =
        textureGather(glossTarget, vec2(2 * block + 1) / vec2(textureSize(glossTarget, 0)), 1).wzxy;
    bvec4 rough = lessThan(abs(roughness - 0.5 * (halfFrom + roughTo)), vec4(0.5 * (roughTo - halfFrom)));
    int index = rough.x ? 0 : rough.y ? 1 : rough.z ? 2 : rough.w ? 3 : -1;
    return index >= 0 && surfaceDepth(pixelOf(block, index)) < 1.0 ? index : -1;
}
