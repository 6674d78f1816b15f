// The surface that a gather pixel stands for, in one texel: xyz its normal, w its plane's offset n.p in volume space.
// (0, 0, 0, 0) where there is none.

// The full-resolution pixel that a gather pixel stands for.
ivec2 gatheredPixel(ivec2 gatherPixel, ivec2 size) {
    return min(gatherPixel * VCT_GATHER_SCALE + VCT_GATHER_SCALE / 2, size - 1);
}

// Whether light gathered on `surface` is also that of a point with this position and normal: within three quarters of
// a voxel of its plane, and within about 32 degrees.
bool sharesSurface(vec3 position, vec3 normal, vec4 surface, float voxel) {
    return dot(surface.xyz, normal) >= 0.85 && abs(dot(surface.xyz, position) - surface.w) < 0.75 * voxel;
}
