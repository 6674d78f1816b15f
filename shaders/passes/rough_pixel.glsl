// The pixel that stands for a block of 2 x 2 pixels in half the resolution, and the surface that it shows.
#include "shared/surface.glsl"
#include "passes/glossy.glsl"

layout(binding = VCT_TEX_G_GLOSS) uniform mediump sampler2D glossTarget;  // metallic, roughness

ivec2 pixelOf(ivec2 block, int index) {
    return min(2 * block + ivec2(index & 1, index >> 1), textureSize(glossTarget, 0) - 1);
}

// The index of the block's first pixel with a surface so rough that half the resolution is enough; -1 if
// there is none.
int roughPixel(ivec2 block) {
    vec2 corner = vec2(2 * block + 1) / vec2(textureSize(glossTarget, 0));
    mediump vec4 metallic = textureGather(glossTarget, corner, 0).wzxy;
    mediump vec4 roughness = textureGather(glossTarget, corner, 1).wzxy;
    // Metals are at 1 in sign(), so that they have no upper limit.
    bvec4 below = lessThan(roughness - roughTo, sign(metallic));
    bvec4 rough = lessThan(vec4(halfFrom), roughness * vec4(below));
    int index = rough.x ? 0 : rough.y ? 1 : rough.z ? 2 : rough.w ? 3 : -1;
    return index >= 0 && surfaceDepth(pixelOf(block, index)) < 1.0 ? index : -1;
}

// A pixel's surface, with which those of other pixels are compared.
struct RoughSurface {
    vec3 position, normal;
    mediump float roughness;
    vec4 plane;  // in window coordinates, scaled so that it gives pixels
    float minCosine;
};

RoughSurface roughSurface(ivec2 pixel) {
    mediump float roughness = texelFetch(glossTarget, pixel, 0).g;
    vec3 position = surfacePosition(vec2(pixel) + 0.5, surfaceDepth(pixel)), normal = shadingNormal(pixel);
    vec4 plane =
        vec4(normal, -dot(normal, position)) * frame.volumeFromWindow / length(frame.volumeFromWindow[0].xyz);
    // The normals may differ by the half angle of the lobe. With less, a small ball has too few blocks to
    // share.
    float alpha = roughness * roughness;
    return RoughSurface(position, normal, roughness, plane, 1.0 - 0.5 * alpha * alpha);
}

// True if a pixel shows the same surface: not further from the plane than a pixel is wide.
bool isOn(RoughSurface surface, ivec2 pixel) {
    float away = dot(surface.plane, vec4(vec2(pixel) + 0.5, surfaceDepth(pixel), 1.0));
    mediump float difference = abs(texelFetch(glossTarget, pixel, 0).g - surface.roughness);
    return abs(away) < 1.0 && difference < 0.1 &&
           dot(shadingNormal(pixel), surface.normal) >= surface.minCosine;
}
