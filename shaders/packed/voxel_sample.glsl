// Samples the packed voxels. Integer textures cannot be filtered, so the eight texels around a position are
// fetched and weighted here.
#include "shared/frame.glsl"

layout(binding = VCT_TEX_VOXELS) uniform usampler3D voxels;

// The two texels per axis around a position, and their weights. Texels outside of the volume have weight 0.
struct Footprint {
    ivec3 low, high;
    mediump vec3 lowWeight, highWeight;
};

Footprint footprint(vec3 positionVolume, int level) {
    int last = (frame.gridSide >> level) - 1;
    vec3 texel = positionVolume * float(last + 1) - 0.5;
    vec3 whole = floor(texel);
    mediump vec3 part = texel - whole;
    ivec3 low = ivec3(whole);
    ivec3 high = low + 1;
    Footprint f;
    f.low = clamp(low, ivec3(0), ivec3(last));
    f.high = clamp(high, ivec3(0), ivec3(last));
    // Either texel can be outside on either side, because a sample may be outside by half a voxel of a
    // coarser level.
    f.lowWeight = mix(vec3(0.0), 1.0 - part, equal(f.low, low));
    f.highWeight = mix(vec3(0.0), part, equal(f.high, high));
    return f;
}

uint voxelWord(int x, int y, int z, int level) {
    return texelFetch(voxels, ivec3(x, y, z), level).r;
}

// A voxel is opaque as soon as one of its children is.
mediump float voxelOpacity(uint word) {
    return word != 0u ? 1.0 : 0.0;
}

// Premultiplied radiance, relative to E/pi, and opacity. A voxel's colour is the mean of its children's if
// any of them is lit, and black otherwise (published program).
mediump vec4 unpackSample(uint word) {
    mediump float opacity = voxelOpacity(word);
    mediump float scale =
        voxelLight(word) != 0u ? 1.0 / (float(VCT_COLOR_STEPS) * float(voxelCount(word))) : 0.0;
    return vec4(vec3(voxelColor(word)) * scale, opacity);
}

mediump vec4 sampleVoxels(vec3 positionVolume, int level) {
    Footprint f = footprint(positionVolume, level);
    mediump vec2 z = vec2(f.lowWeight.z, f.highWeight.z);
    mediump vec4 ll = unpackSample(voxelWord(f.low.x, f.low.y, f.low.z, level)) * z.x +
                      unpackSample(voxelWord(f.low.x, f.low.y, f.high.z, level)) * z.y;
    mediump vec4 lh = unpackSample(voxelWord(f.low.x, f.high.y, f.low.z, level)) * z.x +
                      unpackSample(voxelWord(f.low.x, f.high.y, f.high.z, level)) * z.y;
    mediump vec4 hl = unpackSample(voxelWord(f.high.x, f.low.y, f.low.z, level)) * z.x +
                      unpackSample(voxelWord(f.high.x, f.low.y, f.high.z, level)) * z.y;
    mediump vec4 hh = unpackSample(voxelWord(f.high.x, f.high.y, f.low.z, level)) * z.x +
                      unpackSample(voxelWord(f.high.x, f.high.y, f.high.z, level)) * z.y;
    mediump vec4 l = f.lowWeight.y * ll + f.highWeight.y * lh;
    mediump vec4 h = f.lowWeight.y * hl + f.highWeight.y * hh;
    return f.lowWeight.x * l + f.highWeight.x * h;
}

// The opacities of the two texels along z.
mediump vec2 occupiedPair(int x, int y, Footprint f, int level) {
    return vec2(voxelOpacity(voxelWord(x, y, f.low.z, level)),
                voxelOpacity(voxelWord(x, y, f.high.z, level)));
}

mediump float sampleOpacity(vec3 positionVolume, int level) {
    Footprint f = footprint(positionVolume, level);
    mediump vec2 z = vec2(f.lowWeight.z, f.highWeight.z);
    mediump float ll = dot(z, occupiedPair(f.low.x, f.low.y, f, level));
    mediump float lh = dot(z, occupiedPair(f.low.x, f.high.y, f, level));
    mediump float hl = dot(z, occupiedPair(f.high.x, f.low.y, f, level));
    mediump float hh = dot(z, occupiedPair(f.high.x, f.high.y, f, level));
    mediump float l = f.lowWeight.y * ll + f.highWeight.y * lh;
    mediump float h = f.lowWeight.y * hl + f.highWeight.y * hh;
    return f.lowWeight.x * l + f.highWeight.x * h;
}
