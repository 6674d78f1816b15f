// The surface that a gather pixel stands for, in one texel: position in volume space (16 bits each) and normal
// (octahedral, 8 bits each). Two pixels share light where neither plane nor normal separates them.
#include "shared/octahedral.glsl"

const uvec4 noSurface = uvec4(0u);

uvec4 packSurface(vec3 position, vec3 normal) {
    uvec2 code = encodeNormal(normal) >> 8u;
    return uvec4(uvec3(clamp(position, 0.0, 1.0) * 65535.0 + 0.5), (code.x << 8) | code.y);
}
vec3 packedPosition(uvec4 surface) {
    return vec3(surface.xyz) / 65535.0;
}
vec3 packedNormal(uvec4 surface) {
    return decodeNormal(uvec2(surface.w >> 8, surface.w & 0xFFu) * 257u);
}

// The full-resolution pixel that a gather pixel stands for.
ivec2 gatheredPixel(ivec2 gatherPixel, ivec2 size) {
    return min(gatherPixel * VCT_GATHER_SCALE + VCT_GATHER_SCALE / 2, size - 1);
}

// Whether light gathered at `surface` is that of a point with this position and normal (measured bounds:
// three quarters of a voxel, about 32 degrees).
bool sharesSurface(vec3 position, vec3 normal, uvec4 surface, float voxel) {
    return surface != noSurface && dot(packedNormal(surface), normal) >= 0.85 &&
           abs(dot(packedPosition(surface) - position, normal)) < 0.75 * voxel;
}
