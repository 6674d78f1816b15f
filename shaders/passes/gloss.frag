// Adds the light that glossy surfaces reflect from around the mirror direction to the last pass's picture. A
// smooth surface traces a ray in each pixel. A rough one interpolates between the means of
// passes/gloss_filter.frag, as far as they belong to the same surface, and traces its own rays if none does.
#include "passes/rough_pixel.glsl"
#include "passes/reflection.glsl"

layout(binding = VCT_TEX_G_ALBEDO) uniform mediump sampler2D albedoTarget;
layout(binding = VCT_TEX_HALF_GLOSS) uniform mediump sampler2D halfGloss;

layout(early_fragment_tests) in;
layout(location = 0) out mediump vec4 outRadiance;  // is added; relative to E/pi

// The light of the four blocks around a pixel, interpolated as far as they belong to its surface; a: the sum
// of the weights.
mediump vec4 interpolated(ivec2 pixel, RoughSurface surface) {
    int apart = surface.blockStep;
    ivec2 lastBlock = textureSize(halfGloss, 0) - 1;
    vec2 place = (vec2(pixel) - 0.5) / float(2 * apart), corner = floor(place), f = place - corner;
    mediump vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 next = ivec2(i & 1, i >> 1), block = clamp(apart * (ivec2(corner) + next), ivec2(0), lastBlock);
        vec2 share = abs(1.0 - vec2(next) - f);
        mediump vec4 found = texelFetch(halfGloss, block, 0);
        int index = int(found.a) - 1;
        if (index >= 0) {
            float weight = share.x * share.y * likeness(surface, pixelOf(block, index));
            sum += weight * vec4(found.rgb, 1.0);
        }
    }
    return sum;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    RoughSurface surface = roughSurface(pixel);
    mediump vec4 met = vec4(0.0);
    if (surface.roughness >= halfFrom) met = interpolated(pixel, surface);
    if (met.a < 0.01)
        met = reflectedLight(surface.position, surface.normal, surface.roughness, float(raysOfSample),
                             sampleOf(pixel));
    mediump vec3 albedo = texelFetch(albedoTarget, pixel, 0).rgb;
    Brdf brdf = brdfOf(albedo * albedo, texelFetch(glossTarget, pixel, 0).r, surface.roughness,
                       normalize(frame.eye.xyz - surface.position));
    mediump vec3 light = min(met.rgb / max(met.a, 1e-4), 6e4);
    outRadiance = vec4(brdf.lobeShare * specularShare(brdf, surface.normal) * light, 0.0);
}
