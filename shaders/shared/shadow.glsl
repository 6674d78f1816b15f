// The shadow map's answer: how much of the directional light reaches a point.
#include "shared/frame.glsl"

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

// The same where the receiver's plane is known. A bias lifts the receiver over what touches it: along the creases of a room
// whose walls have no thickness the sun would shine in, as wide as the bias and as a texel, beyond whose half there is no
// wall any more. So each of the filter's four texels is compared with the plane where the texel is, and is nearer than the
// surface, farther, or the surface itself. Texels that are farther look past the surface's border, and know nothing of it.
layout(binding = VCT_TEX_SHADOW_DEPTH) uniform highp sampler2D shadowDepth;  // the same map, not compared

// A surface may be off its plane by this share of a texel, and of what the plane rises from a texel to its diagonal
// neighbour: corners are rounded to the rasterizer's grid. A curved one is drawn flat, has the normals of a round one and
// needs more; on flat walls as much would take what touches them for the wall.
const float flatSlack = 0.25;
const float curvedSlack = 1.0;
const float depthRounding = 3e-5;  // of the depth range: half a step of 16 bits, and a position from a G-buffer

// What the receiver's plane gains in depth per texel.
vec2 shadowSlope(vec3 normal) {
    // Rows of the matrix are the map's axes, each over its length: normals go by the inverse transpose.
    mat3 axes = transpose(mat3(frame.shadowFromVolume));
    vec3 plane = vec3(dot(axes[0], normal) / dot(axes[0], axes[0]), dot(axes[1], normal) / dot(axes[1], axes[1]),
                      dot(axes[2], normal) / dot(axes[2], axes[2]));
    const float steepest = 64.0;  // depth per length across the map: the light less than a degree above the surface
    return clamp(-plane.xy / plane.z, -steepest, steepest) / vec2(textureSize(shadowDepth, 0));
}

// The four texels of a filter's footprint in a map, beside the receiver's plane. Vectors of four begin at (0, 1) and go
// counter-clockwise, as textureGather() orders its texels.
struct ShadowFootprint {
    vec2 texel;     // the receiver in the map, in texels
    vec2 corner;    // the first of the four
    vec4 above;     // depth of the map over that of the plane
    vec4 blocked;   // 1: nearer to the light than the surface
    float blockers;
    float closest;  // the least of `above`
};

// Texture coordinates for textureGather(): at the corner that the four texels share no rounding chooses others.
vec2 footprintCorner(vec2 receiver, vec2 size) {
    return (floor(receiver * size - 0.5) + 1.0) / size;
}

// A footprint's four values between its texels, as a bilinear filter has them.
float filterFootprint(vec4 four, vec2 f) {
    return mix(mix(four.w, four.z, f.x), mix(four.x, four.y, f.x), f.y);
}

ShadowFootprint shadowFootprint(vec4 depths, vec3 receiver, vec2 size, vec2 slope, float slack) {
    vec2 texel = receiver.xy * size - 0.5;
    vec2 corner = floor(texel);
    vec2 f = texel - corner;
    vec4 above = depths - (receiver.z - dot(slope, f)) - vec4(slope.y, slope.x + slope.y, slope.x, 0.0);
    vec4 blocked = vec4(lessThan(above, vec4(-slack)));
    return ShadowFootprint(texel, corner, above, blocked, dot(blocked, vec4(1.0)),
                           min(min(above.x, above.y), min(above.z, above.w)));
}

// The footprint's light if all four texels agree. At an edge of the shadow or of the surface they do not.
const float footprintAtEdge = 2.0;
float footprintLight(ShadowFootprint four, float slack, float contact) {
    if (all(lessThan(abs(four.above), vec4(slack)))) return 1.0;
    if (four.blockers == 4.0) return four.closest > -contact ? -1.0 : 0.0;
    return footprintAtEdge;
}

// In a crease the edges of the shadow and of the surface are one: beyond the shadow there is no surface, and down the surface
// from its border there is no light. One texel more tells: this one.
vec2 nextOfFootprint(ShadowFootprint four, vec2 slope) {
    vec4 blocked = four.blocked;
    vec2 aside = sign(four.blockers > 0.0 ? blocked.wz + blocked.xw - blocked.yx - blocked.zy : slope);
    return mix(floor(four.texel + 0.5), four.corner + 0.5 + 1.5 * aside, abs(aside));
}

float edgeLight(ShadowFootprint four, vec2 next, float nextDepth, vec3 receiver, vec2 slope, float slack, float contact) {
    float nextAbove = nextDepth - receiver.z - dot(slope, next - four.texel);
    bool crease = four.blockers > 0.0 ? nextAbove > slack : nextAbove < -slack;
    if (crease && min(four.closest, nextAbove) > -contact) return -1.0;
    return 1.0 - filterFootprint(four.blocked, four.texel - four.corner);
}

// The light of a receiver in a map: texture coordinates and depth. `slope`: the depth that its plane gains per texel; `slack`:
// how far a texel's depth may be off that plane and still be the surface itself. -1: no part of a sun is seen, because the
// receiver is in a crease or the blockers of all of the footprint are no farther than `contact` (depth).
float shadowFootprintLight(highp sampler2D map, vec3 receiver, vec2 slope, float slack, float contact) {
    vec2 size = vec2(textureSize(map, 0));
    ShadowFootprint four =
        shadowFootprint(textureGather(map, footprintCorner(receiver.xy, size)), receiver, size, slope, slack);
    float light = footprintLight(four, slack, contact);
    if (light != footprintAtEdge) return light;
    vec2 next = nextOfFootprint(four, slope);
    return edgeLight(four, next, textureLod(map, (next + 0.5) / size, 0.0).r, receiver, slope, slack, contact);
}

// Of the four texels around a receiver, how many are its own surface, and how many block the light. The others are farther:
// they look past the surface's border, and tell nothing of it.
vec2 shadowTexels(highp sampler2D map, vec3 receiver, vec2 slope, float slack) {
    vec2 size = vec2(textureSize(map, 0));
    ShadowFootprint four =
        shadowFootprint(textureGather(map, footprintCorner(receiver.xy, size)), receiver, size, slope, slack);
    return vec2(dot(vec4(lessThan(abs(four.above), vec4(slack))), vec4(1.0)), four.blockers);
}

// The depth by which a texel may be off the receiver's plane and still be its own surface. `slackShare`: flatSlack to
// curvedSlack.
float sunSlack(vec2 slope, float slackShare) {
    // The depth range is no shorter than the map is wide.
    float texel = 0.25 / float(textureSize(shadowDepth, 0).x);
    return slackShare * (abs(slope.x) + abs(slope.y) + texel) + depthRounding;
}

float shadowMapLightOn(vec3 positionVolume, vec3 normal, float slackShare) {
    if (dot(normal, frame.directionToLight.xyz) <= 0.0) return 0.0;
    vec3 shadow = (frame.shadowFromVolume * vec4(positionVolume, 1.0)).xyz;
    if (any(greaterThan(abs(shadow - 0.5), vec3(0.5)))) return 1.0;  // the map does not reach there
    vec2 slope = shadowSlope(normal);
    return max(shadowFootprintLight(shadowDepth, shadow, slope, sunSlack(slope, slackShare), 2.0), 0.0);
}
