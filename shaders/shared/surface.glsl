// The surface under a pixel, from the G-buffer.
#include "shared/frame.glsl"
#include "shared/normals.glsl"

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

struct SurfaceNormals {
    vec3 shading;    // with the normal map
    vec3 geometric;  // interpolated, for look-ups in voxels, which have no normal maps
    vec3 face;       // of the triangle's plane, for look-ups in shadow maps
    bool isCurved;   // the triangle's plane differs from the interpolated normal
};

// The interpolated normal.
vec3 geometricNormal(ivec2 pixel) {
    return decodeNormal(texelFetch(normalTarget, pixel, 0).rg);
}

// The normal with the normal map.
vec3 shadingNormal(ivec2 pixel) {
#ifdef VCT_MAPPED_NORMALS
    return decodeOctahedral(texelFetch(normalTarget, pixel, 0).ba, 65534.0);
#else
    return geometricNormal(pixel);
#endif
}

// `albedoAlpha`: alpha of the albedo.
SurfaceNormals surfaceNormals(ivec2 pixel, float albedoAlpha) {
    uvec4 code = texelFetch(normalTarget, pixel, 0);
    vec3 geometric = decodeNormal(code.rg);
    FaceNormal face = decodeFaceNormal(code.rg, albedoAlpha);
#ifdef VCT_MAPPED_NORMALS
    vec3 shading = decodeOctahedral(code.ba, 65534.0);
#else
    vec3 shading = geometric;
#endif
    return SurfaceNormals(shading, geometric, face.normal, !face.isInterpolated);
}
