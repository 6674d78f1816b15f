// The light of a pixel that all last passes compute alike: that of punctual lights which the surface
// reflects, and that which it emits. Surfaces are glossy if the scene has glossy materials, else Lambertian.
#include "shared/surface.glsl"
#include "passes/penumbra.glsl"
#ifdef VCT_GLOSS_TARGET
#include "passes/glossy.glsl"
#else
struct Brdf {
    mediump vec3 diffuse;
};
mediump vec3 evaluateBrdf(Brdf brdf, vec3 normal, vec3 toLight) {
    return brdf.diffuse * max(dot(normal, toLight), 0.0);
}
#endif

#ifdef VCT_PUNCTUAL_LIGHTS
#include "shared/punctual_lights.glsl"
// The light of the punctual lights that the surface reflects towards the eye, relative to the sun's E/pi.
mediump vec3 shadePunctualLights(Brdf brdf, vec3 position, SurfaceNormals normals) {
    float slackShare = slackShareOf(normals.isCurved);
    vec3 sum = vec3(0.0);
    const bool shadows = VCT_SHOWS_HARD_SHADOW || VCT_SHOWS_SOFT_SHADOW;
    for (int i = 0; i < punctual.count.x; ++i) {
        LightAt light = lightAt(i, position);
        vec3 left = evaluateBrdf(brdf, normals.shading, light.towards) * light.irradiance;
        if (left == vec3(0.0)) continue;
        sum +=
            shadows ? left * punctualVisibility(i, position, normals.face, light.towards, slackShare) : left;
    }
    return min(sum, 6e4);
}
#else
mediump vec3 shadePunctualLights(Brdf brdf, vec3 position, SurfaceNormals normals) {
    return vec3(0.0);
}
#endif

#ifdef VCT_EMISSIVE_TARGET
layout(binding = VCT_TEX_G_EMISSIVE) uniform mediump sampler2D emissiveTarget;
mediump vec3 emitted(ivec2 pixel) {
    return texelFetch(emissiveTarget, pixel, 0).rgb;
}
#else
mediump vec3 emitted(ivec2 pixel) {
    return vec3(0.0);
}
#endif
