// The surface that a gather pixel stands for, in one texel: xyz its normal, w its plane's offset n.p in volume space.
// (0, 0, 0, 0) where there is none.
#include "shared/surface.glsl"
#include "shared/trips.glsl"

// Gather pixels are stored by their place in the pattern of 4 x 4 rotations: 16 tiles side by side, all of whose pixels send their
// cones the same ways. Neighbours on the screen then do the same work and read the same texels (Keller and Heidrich
// 2001, "Interleaved Sampling"; Bavoil 2014, "Deinterleaved Texturing").
ivec2 tileSize(ivec2 size) {
    return (size + (4 * VCT_GATHER_SCALE - 1)) / (4 * VCT_GATHER_SCALE);
}

ivec2 storedPixel(ivec2 gatherPixel, ivec2 tile) {
    return ivec2(((gatherPixel.y & 3) * 4 + (gatherPixel.x & 3)) * tile.x, 0) + (gatherPixel >> 2);
}

// The full-resolution pixel that a gather pixel stands for: the middle of its block, or, where that is sky, another of
// the block's with a surface. A thing thinner than the block would otherwise find no light at all before the sky.
// `trips`: the counter of its loop, which most pixels skip.
ivec2 gatheredPixel(ivec2 gatherPixel, ivec2 size, int trips) {
    const int quads = (VCT_GATHER_SCALE + 1) / 2;  // along a side of the block
    ivec2 first = gatherPixel * VCT_GATHER_SCALE;
    ivec2 found = min(first + VCT_GATHER_SCALE / 2, size - 1);
    int search = surfaceDepth(found) == 1.0 ? quads * quads : 0;
    for (int i = 0; i < search; ++i) {
        TRIP(trips);
        ivec2 corner = first + 2 * ivec2(i % quads, i / quads);
        // The components are the pixels (0, 1), (1, 1), (1, 0), (0, 0).
        vec4 depths = textureGather(depthTarget, vec2(corner + 1) / vec2(size));
        if (depths.x != 1.0) found = corner + ivec2(0, 1);
        if (depths.y != 1.0) found = corner + ivec2(1, 1);
        if (depths.z != 1.0) found = corner + ivec2(1, 0);
        if (depths.w != 1.0) found = corner;
    }
    return min(found, size - 1);
}

// Whether light gathered on `surface` is also that of a point with this position and normal: within three quarters of
// a voxel of its plane, and within about 32 degrees.
bool sharesSurface(vec3 position, vec3 normal, vec4 surface, float voxel) {
    return dot(surface.xyz, normal) >= 0.85 && abs(dot(surface.xyz, position) - surface.w) < 0.75 * voxel;
}
