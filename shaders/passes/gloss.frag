// Adds the light that glossy surfaces reflect from around the mirror direction to the last pass's picture. A
// smooth surface traces a few rays in each pixel. A rough one interpolates between the samples of
// passes/gloss_half.frag, as far as they belong to the same surface, and traces its own rays if none does.
#include "passes/rough_pixel.glsl"
#include "passes/reflection.glsl"

layout(binding = VCT_TEX_G_ALBEDO) uniform mediump sampler2D albedoTarget;
layout(binding = VCT_TEX_HALF_GLOSS) uniform mediump sampler2D halfGloss;

layout(early_fragment_tests) in;
layout(location = 0) out mediump vec4 outRadiance;  // is added; relative to E/pi

// The samples of the 2 x 2 blocks around a pixel that belong to its surface, weighted so that their sum fits
// into half floats; a: the sum of the weights. Together the four have an even set of directions
// (turnOfPixel()).
mediump vec4 interpolated(ivec2 pixel, vec3 position, vec3 normal, mediump float roughness) {
    // The plane of the surface in window coordinates, scaled so that it gives pixels: samples may be as far
    // from the plane as a pixel is wide.
    vec4 plane =
        vec4(normal, -dot(normal, position)) * frame.volumeFromWindow / length(frame.volumeFromWindow[0].xyz);
    // The normals may differ by the half angle of the lobe.
    float alpha = roughness * roughness, minCosine = 1.0 - 0.5 * alpha * alpha;
    ivec2 lastBlock = textureSize(halfGloss, 0) - 1;
    mediump vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 block = clamp(((pixel - 1) >> 1) + ivec2(i & 1, i >> 1), ivec2(0), lastBlock);
        mediump vec4 found = texelFetch(halfGloss, block, 0);
        int index = int(found.a) - 1;
        ivec2 of = pixelOf(block, max(index, 0));
        float away = dot(plane, vec4(vec2(of) + 0.5, surfaceDepth(of), 1.0));
        mediump float difference = abs(texelFetch(glossTarget, of, 0).g - roughness);
        if (index >= 0 && abs(away) < 1.0 && difference < 0.1 && dot(shadingNormal(of), normal) >= minCosine)
            sum += 0.25 * vec4(found.rgb, 1.0);
    }
    return sum;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    mediump float roughness = texelFetch(glossTarget, pixel, 0).g;
    vec3 position = surfacePosition(gl_FragCoord.xy, surfaceDepth(pixel));
    vec3 normal = shadingNormal(pixel);
    mediump vec4 met = vec4(0.0);
    if (roughness >= halfFrom) met = interpolated(pixel, position, normal, roughness);
    if (met.a > 0.0)
        met.rgb /= met.a;
    else
        met.rgb = reflectedLight(position, normal, roughness, 4, turnOfPixel(pixel));
    mediump vec3 albedo = texelFetch(albedoTarget, pixel, 0).rgb;
    Brdf brdf = brdfOf(albedo * albedo, texelFetch(glossTarget, pixel, 0).r, roughness,
                       normalize(frame.eye.xyz - position));
    outRadiance = vec4(lobeShare(roughness) * specularShare(brdf, normal) * met.rgb, 0.0);
}
