// The shadow map's answer: how much of the directional light reaches a point.
#include "shared/blocks.glsl"

layout(binding = VCT_TEX_SHADOW_MAP) uniform sampler2DShadow shadowMap;

// 0 in shadow, 1 in light; between them where the four taps of the hardware's percentage-closer filter differ.
// Bias by the thesis's eq. 4.1-4.3, in units of the depth range, with tan(acos x) written as sqrt(1 - x^2) / x
// so that it stays finite at grazing light.
float shadowMapLight(vec3 positionVolume, float cosTheta) {
    const float slopeBias = 0.005;   // thesis eq. 4.2
    const float largestBias = 0.01;  // thesis eq. 4.3
    // Where the light is perpendicular the slope is 0, and rounding alone would shade the surface by itself.
    const float smallestBias = 1e-4;
    float slope = sqrt(max(1.0 - cosTheta * cosTheta, 0.0)) / max(cosTheta, 1e-4);
    float bias = clamp(slopeBias * slope, smallestBias, largestBias);
    vec3 shadow = (frame.shadowFromVolume * vec4(positionVolume, 1.0)).xyz;
    return texture(shadowMap, vec3(shadow.xy, shadow.z - bias));
}

// The same where the receiver's plane is known: the bias is what the plane rises over the texels that the filter reads,
// and no more. Along the creases of a room the bias above lets the sun in, as wide as itself.
float shadowMapLightOn(vec3 positionVolume, vec3 normal) {
    const float steepest = 64.0;      // depth per length across the map
    const float roundingBias = 1e-4;  // as above
    if (dot(normal, frame.towardsLight.xyz) <= 0.0) return 0.0;
    // Rows of the matrix are the map's axes, each over its length: normals go by the inverse transpose.
    mat3 axes = transpose(mat3(frame.shadowFromVolume));
    vec3 plane = vec3(dot(axes[0], normal) / dot(axes[0], axes[0]), dot(axes[1], normal) / dot(axes[1], axes[1]),
                      dot(axes[2], normal) / dot(axes[2], axes[2]));
    vec2 slope = min(abs(plane.xy / plane.z), steepest);
    float bias = dot(slope, 1.0 / vec2(textureSize(shadowMap, 0))) + roundingBias;
    vec3 shadow = (frame.shadowFromVolume * vec4(positionVolume, 1.0)).xyz;
    return texture(shadowMap, vec3(shadow.xy, shadow.z - bias));
}
