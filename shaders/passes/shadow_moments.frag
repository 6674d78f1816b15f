// Computes the finest level of the shadow map's moments (shared/moments.glsl), at half the map's resolution.
#include "shared/counters.glsl"
#include "shared/moments.glsl"

layout(binding = VCT_TEX_SHADOW_DEPTH) uniform highp sampler2D finest;

layout(location = 0) out vec2 outMoments;

void main() {
    COUNT(VCT_COUNTER_SHADOW_MOMENTS);
    vec2 at = (2.0 * gl_FragCoord.xy - 1.0) / vec2(textureSize(finest, 0));
    vec4 a = textureGather(finest, at), b = textureGatherOffset(finest, at, ivec2(2, 0));
    vec4 c = textureGatherOffset(finest, at, ivec2(0, 2)), d = textureGatherOffset(finest, at, ivec2(2, 2));
    // Replace far-plane texels by the nearest depth around; otherwise light leaks at silhouettes, for example
    // into the creases of walls without thickness.
    vec4 nearestOfFour = min(min(a, b), min(c, d));
    vec4 nearest = vec4(min(min(nearestOfFour.x, nearestOfFour.y), min(nearestOfFour.z, nearestOfFour.w)));
    vec4 nothing = vec4(1.0);  // far plane
    a = mix(a, nearest, equal(a, nothing));
    b = mix(b, nearest, equal(b, nothing));
    c = mix(c, nearest, equal(c, nothing));
    d = mix(d, nearest, equal(d, nothing));
    vec2 moments = momentsOf(a, b, c, d);
    outMoments =
        vec2(moments.x - momentMiddle, moments.y * momentUnit + minVariance / momentUnit) * momentUnit;
}
