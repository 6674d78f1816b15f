// The surface under a pixel, from the G-buffer.
#include "shared/frame.glsl"
#include "shared/octahedral.glsl"

layout(binding = VCT_TEX_G_NORMAL) uniform usampler2D normalTarget;
layout(binding = VCT_TEX_G_DEPTH) uniform sampler2D depthTarget;

float surfaceDepth(ivec2 pixel) {
    return texelFetch(depthTarget, pixel, 0).r;
}

// Position in volume space. `window`: gl_FragCoord.xy.
vec3 surfacePosition(vec2 window, float depth) {
    vec4 p = frame.volumeFromWindow * vec4(window, depth, 1.0);
    return p.xyz / p.w;
}

// The normal for shading, with the normal map.
vec3 surfaceNormal(ivec2 pixel) {
    return decodeNormal(texelFetch(normalTarget, pixel, 0).rg);
}

// The geometric normal, for look-ups in shadow maps and voxels, which have no normal maps. `mapped`:
// surfaceNormal().
#ifdef VCT_MAPPED_NORMALS
vec3 geometryNormal(ivec2 pixel, vec3 mapped) {
    return decodeNormal(texelFetch(normalTarget, pixel, 0).ba);
}
#else
vec3 geometryNormal(ivec2 pixel, vec3 mapped) {
    return mapped;
}
#endif
