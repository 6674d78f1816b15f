// The pixel that stands for a block of 2 x 2 pixels in half the resolution, and the surface that it shows. Of
// materials that are no metals only every second block along each axis has one if their lobe is wide.
#include "shared/surface.glsl"
#include "passes/glossy.glsl"

layout(binding = VCT_TEX_G_GLOSS) uniform mediump sampler2D glossTarget;  // metallic, roughness

ivec2 pixelOf(ivec2 block, int index) {
    return min(2 * block + ivec2(index & 1, index >> 1), textureSize(glossTarget, 0) - 1);
}

// The step from one block with rays to the next along each axis. `gloss`: metallic, roughness.
int stepOfBlocks(mediump vec2 gloss) {
    return gloss.y >= quarterFrom && gloss.x == 0.0 ? 2 : 1;
}

// The index of the block's first pixel with a surface so rough that half the resolution is enough; -1 if
// there is none, or if that surface takes no rays in this block.
int roughPixel(ivec2 block) {
    vec2 corner = vec2(2 * block + 1) / vec2(textureSize(glossTarget, 0));
    mediump vec4 metallic = textureGather(glossTarget, corner, 0).wzxy;
    mediump vec4 roughness = textureGather(glossTarget, corner, 1).wzxy;
    // Metals are at 1 in sign(), so that they have no upper limit.
    bvec4 below = lessThan(roughness - roughTo, sign(metallic));
    bvec4 rough = lessThan(vec4(halfFrom), roughness * vec4(below));
    int index = rough.x ? 0 : rough.y ? 1 : rough.z ? 2 : rough.w ? 3 : -1;
    if (index < 0) return -1;
    ivec2 pixel = pixelOf(block, index);
    int apart = stepOfBlocks(texelFetch(glossTarget, pixel, 0).rg);
    return ((block.x | block.y) & (apart - 1)) == 0 && surfaceDepth(pixel) < 1.0 ? index : -1;
}

// A pixel's surface, with which those of other pixels are compared.
struct RoughSurface {
    vec3 position, normal;
    mediump float roughness;
    int blockStep;
    vec4 plane;  // in window coordinates, scaled so that it gives pixels
    float perCosine;
};

RoughSurface roughSurface(ivec2 pixel) {
    mediump vec2 gloss = texelFetch(glossTarget, pixel, 0).rg;
    vec3 position = surfacePosition(vec2(pixel) + 0.5, surfaceDepth(pixel)), normal = shadingNormal(pixel);
    vec4 plane =
        vec4(normal, -dot(normal, position)) * frame.volumeFromWindow / length(frame.volumeFromWindow[0].xyz);
    float alpha = gloss.y * gloss.y;
    return RoughSurface(position, normal, gloss.y, stepOfBlocks(gloss), plane, 2.0 / (alpha * alpha));
}

// The weight of another pixel's reflection. It is half if the pixel is a pixel's width away from the plane of
// the surface, or if the normals differ by the half angle of the lobe. It falls smoothly, because the rim of
// a ball has no pixels that are nearer.
float likeness(RoughSurface surface, ivec2 pixel) {
    float away = dot(surface.plane, vec4(vec2(pixel) + 0.5, surfaceDepth(pixel), 1.0));
    float turned = surface.perCosine * (1.0 - dot(shadingNormal(pixel), surface.normal));
    vec2 squares = vec2(away * away, turned);
    squares *= squares;
    mediump float difference = abs(texelFetch(glossTarget, pixel, 0).g - surface.roughness);
    return difference < 0.1 ? 1.0 / ((1.0 + squares.x) * (1.0 + squares.y)) : 0.0;
}
