// Look-ups in the sun's shadow map: the share of the sun's light that reaches a point.
#include "shared/frame.glsl"
#include "directional/cascades.glsl"

layout(binding = VCT_TEX_SHADOW_MAP) uniform sampler2DShadow shadowMap;

// The sun's shadow map around a point. With cascades, the texture has 2 x 2 tiles, each a map of its own:
// three around cascades near the camera, finest first, and one of the whole scene
// (jni/engine/frame_uniforms.h).
struct SunMap {
    mat4 fromVolume;  // texture coordinates and depth
    vec2 coneRadius;  // radius of the sun's cone per depth, in texture coordinates along two perpendicular
                      // axes
    vec2 coneTexel;   // width of the texels, in radii of the sun's cone per depth
};
SunMap sunMapAt(vec3 positionVolume) {
    if (cascades == 1) return SunMap(frame.shadowFromVolume, frame.shadowConeRadius, frame.shadowConeTexel);
    int tile = 0;
    for (; tile < VCT_SHADOW_TILES - 1; ++tile) {
        vec2 map = (frame.shadowTileFromVolume[tile] * vec4(positionVolume, 1.0)).xy;
        vec2 fromCentre = abs(map * 2.0 - vec2(tile & 1, tile >> 1) - 0.5);
        if (max(fromCentre.x, fromCentre.y) < 0.5 - VCT_SHADOW_TILE_MARGIN) break;
    }
    vec4 cone = frame.shadowTileCone[tile];
    return SunMap(frame.shadowTileFromVolume[tile], cone.xy, cone.zw);
}
vec3 inSunMap(SunMap map, vec3 positionVolume) {
    return (map.fromVolume * vec4(positionVolume, 1.0)).xyz;
}

// The thesis's shadow: 0 in shadow, 1 in light, and values between them if the four taps of the hardware's
// percentage-closer filter differ. The bias is eq. 4.1-4.3, in units of the depth range, with tan(acos x)
// written as sqrt(1 - x^2) / x, so that it stays finite at grazing light.
float shadowMapLight(vec3 positionVolume, float cosTheta) {
    const float slopeBias = 0.005;  // thesis eq. 4.2
    const float maxBias = 0.01;     // thesis eq. 4.3
    // At perpendicular light the slope is 0, and rounding would make the surface shadow itself.
    const float minBias = 1e-4;
    float slope = sqrt(max(1.0 - cosTheta * cosTheta, 0.0)) / max(cosTheta, 1e-4);
    float bias = clamp(slopeBias * slope, minBias, maxBias);
    vec3 shadow = (frame.shadowFromVolume * vec4(positionVolume, 1.0)).xyz;
    return texture(shadowMap, vec3(shadow.xy, shadow.z - bias));
}

// The following functions know the receiver's plane and need no bias. With a bias, light would leak in along
// the creases of a room with walls of no thickness. Each of the filter's four texels is compared with the
// plane at the texel's own position. It is nearer to the light than the surface, or farther, or the surface
// itself. A farther texel lies beyond the border of the surface and tells nothing about its shadow.
layout(binding = VCT_TEX_SHADOW_DEPTH) uniform highp sampler2D shadowDepth;  // the map without comparison

// Tolerance for a surface's depth in the map around its plane, as a share of a texel and of the plane's rise
// between diagonal neighbours, because the rasterizer rounds corners. A curved surface is drawn with flat
// triangles but has the normals of a round one, and needs more. For flat walls more would hide objects that
// touch them.
const float flatSlack = 0.25;
const float curvedSlack = 1.0;
float slackShareOf(bool isCurved) {
    return isCurved ? curvedSlack : flatSlack;
}

const float depthRounding = 3e-5;  // depth error: half a step of 16 bits, and a position from the G-buffer

// The slope of the receiver's plane: depth per length across the light, in radii of the sun's cone per depth,
// along the map's first axis and perpendicular to it.
vec2 coneSlope(vec3 normal) {
    vec3 plane = mat3(frame.shadowSlopeFromNormal) * normal;
    return plane.xy / max(-plane.z, 1.0 / 64.0);  // the sun is at least a degree above the surface
}

// The same as depth per texel along the map's two coordinates, which are not perpendicular to each other.
vec2 shadowSlope(SunMap map, vec2 slope) {
    return vec2(slope.x - frame.shadowShear * slope.y, slope.y) * map.coneTexel;
}

// The four texels of a bilinear filter, compared with the receiver's plane. The components of a vec4 are in
// the order of textureGather(): they begin at (0, 1) and go counter-clockwise.
struct ShadowFootprint {
    vec2 texel;      // position of the receiver, in texels
    vec2 corner;     // position of the first of the four texels
    vec4 above;      // depth in the map minus depth of the plane
    vec4 blocked;    // 1: the texel is nearer to the light than the surface
    float blockers;  // number of texels that block the light
    float onPlane;   // number of texels that show the surface itself
    float closest;   // minimum of `above`
};

// Texture coordinates for textureGather(): the corner that the four texels share, so that rounding cannot
// select other texels.
vec2 footprintCorner(vec2 receiver, vec2 size) {
    return (floor(receiver * size - 0.5) + 1.0) / size;
}

// Bilinear interpolation of a footprint's four values.
float filterFootprint(vec4 four, vec2 f) {
    return mix(mix(four.w, four.z, f.x), mix(four.x, four.y, f.x), f.y);
}

ShadowFootprint shadowFootprint(vec4 depths, vec3 receiver, vec2 size, vec2 slope, float slack) {
    vec2 texel = receiver.xy * size - 0.5;
    vec2 corner = floor(texel);
    vec2 f = texel - corner;
    vec4 above = depths - (receiver.z - dot(slope, f)) - vec4(slope.y, slope.x + slope.y, slope.x, 0.0);
    vec4 blocked = vec4(lessThan(above, vec4(-slack)));
    vec4 onPlane = vec4(lessThan(abs(above), vec4(slack)));
    return ShadowFootprint(texel, corner, above, blocked, dot(blocked, vec4(1.0)), dot(onPlane, vec4(1.0)),
                           min(min(above.x, above.y), min(above.z, above.w)));
}

// In a crease the edge of the shadow is also an edge of the surface. Such an edge is recognized by one more
// texel, on the other side of the edge. This returns its position.
vec2 tieBreakTexel(ShadowFootprint four, vec2 slope) {
    vec2 difference = four.blocked.wx - four.blocked.yz;
    vec2 aside =
        four.blockers > 0.0 ? vec2(difference.x + difference.y, difference.x - difference.y) : slope * 1e12;
    return four.corner + floor(1.0 + 1.5 * clamp(aside, -1.0, 1.0));
}

// True if blockers are in a crease. `nextAbove`: depth at tieBreakTexel(), relative to the receiver's plane.
// Three texels that show the surface itself are around the corner of a shadow.
bool isCrease(ShadowFootprint four, float nextAbove, float slack) {
    return four.blockers > 0.0 && four.onPlane < 3.0 && nextAbove > slack;
}

// The light of a receiver at an edge of the shadow or of the surface. All of the four texels may lie beyond
// the crease.
float edgeLight(ShadowFootprint four, float nextAbove, float slack) {
    bool isDark = four.blockers > 0.0 ? isCrease(four, nextAbove, slack) : nextAbove < -slack;
    return isDark ? 0.0 : 1.0 - filterFootprint(four.blocked, four.texel - four.corner);
}

// The light of a receiver (texture coordinates and depth in a map): 0 in shadow and in creases. `slope`:
// depth of its plane per texel. `slack`: tolerance in depth for texels of the surface itself.
float shadowFootprintLight(highp sampler2D map, vec3 receiver, vec2 slope, float slack) {
    vec2 size = vec2(textureSize(map, 0));
    ShadowFootprint four =
        shadowFootprint(textureGather(map, footprintCorner(receiver.xy, size)), receiver, size, slope, slack);
    if (max(four.blockers, four.onPlane) == 4.0) return 0.25 * four.onPlane;
    vec2 next = tieBreakTexel(four, slope);
    float nextAbove =
        textureLod(map, (next + 0.5) / size, 0.0).r - receiver.z - dot(slope, next - four.texel);
    return edgeLight(four, nextAbove, slack);
}

// True if all of the four texels block the light, or if they are in a crease. `nearest`: the smallest depth
// of the five texels, relative to the receiver's plane.
bool isHardShadow(vec3 receiver, vec2 size, vec2 slope, float slack, out float nearest) {
    ShadowFootprint four = shadowFootprint(textureGather(shadowDepth, footprintCorner(receiver.xy, size)),
                                           receiver, size, slope, slack);
    vec2 next = tieBreakTexel(four, slope);
    float nextAbove =
        textureLod(shadowDepth, (next + 0.5) / size, 0.0).r - receiver.z - dot(slope, next - four.texel);
    nearest = min(four.closest, nextAbove);
    return four.blockers == 4.0 || isCrease(four, nextAbove, slack);
}

// The number of texels around a receiver that show its own surface, and the number of texels that block the
// light. The others are farther: they lie beyond the border of the surface and tell nothing about its shadow.
vec2 shadowTexels(highp sampler2D map, vec3 receiver, vec2 slope, float slack) {
    vec2 size = vec2(textureSize(map, 0));
    ShadowFootprint four =
        shadowFootprint(textureGather(map, footprintCorner(receiver.xy, size)), receiver, size, slope, slack);
    return vec2(four.onPlane, four.blockers);
}

// The tolerance in depth for texels of the receiver's own surface. `slackShare`: flatSlack to curvedSlack.
float sunSlack(vec2 slope, float slackShare) {
    // The depth range is at least as long as the map is wide.
    float texel = 0.25 / float(textureSize(shadowDepth, 0).x);
    return slackShare * (abs(slope.x) + abs(slope.y) + texel) + depthRounding;
}

// The share of the sun's light that reaches a surface: 0 in shadow, 1 in light, with hard edges.
float shadowMapLightOn(vec3 positionVolume, vec3 normal, float slackShare) {
    if (dot(normal, frame.directionToLight.xyz) <= 0.0) return 0.0;
    SunMap map = sunMapAt(positionVolume);
    vec3 shadow = inSunMap(map, positionVolume);
    if (any(greaterThan(abs(shadow - 0.5), vec3(0.5)))) return 1.0;  // the map does not reach there
    vec2 slope = shadowSlope(map, coneSlope(normal));
    return shadowFootprintLight(shadowDepth, shadow, slope, sunSlack(slope, slackShare));
}
