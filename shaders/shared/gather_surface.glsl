// The surface that a gather pixel stands for, in one texel: xyz its normal, w its plane's offset n.p in volume space.
// (0, 0, 0, 0) where there is none.
#include "shared/surface.glsl"

// The full-resolution pixel that a gather pixel stands for: the middle of its block, or, where that is sky, another of
// the block's with a surface. A thing thinner than the block would otherwise find no light at all before the sky.
ivec2 gatheredPixel(ivec2 gatherPixel, ivec2 size) {
    ivec2 first = gatherPixel * VCT_GATHER_SCALE;
    ivec2 middle = min(first + VCT_GATHER_SCALE / 2, size - 1);
    if (surfaceDepth(middle) != 1.0) return middle;
    for (int i = 0; i < VCT_GATHER_SCALE * VCT_GATHER_SCALE; ++i) {
        ivec2 pixel = min(first + ivec2(i % VCT_GATHER_SCALE, i / VCT_GATHER_SCALE), size - 1);
        if (surfaceDepth(pixel) != 1.0) return pixel;
    }
    return middle;
}

// Whether light gathered on `surface` is also that of a point with this position and normal: within three quarters of
// a voxel of its plane, and within about 32 degrees.
bool sharesSurface(vec3 position, vec3 normal, vec4 surface, float voxel) {
    return dot(surface.xyz, normal) >= 0.85 && abs(dot(surface.xyz, position) - surface.w) < 0.75 * voxel;
}
