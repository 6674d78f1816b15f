// The sun's soft shadow from the shadow map and its moments (shared/moments.glsl), filtered as variance
// shadow maps are (Donnelly and Lauritzen 2006). It reads the hard shadow's five texels, seven
// more depths and, if anything blocks the light, VCT_FILTER_TAPS samples of the moments. The cost does not
// grow with the width of the penumbra.
#include "shared/shadow.glsl"
#include "shared/moments.glsl"
#include "shared/counters.glsl"

layout(binding = VCT_TEX_SHADOW_MOMENTS) uniform highp sampler2D shadowMoments;

// The taps of the search for blockers form a Vogel disc whose radii grow linearly, because blockers close to
// the receiver are within the cone only near its axis. With 6 taps penumbrae have steps where the search
// misses the edge. 16 taps gain 0.001 in the courtyard. These are the offsets of 7 taps and one over their
// radii, in two vectors, because a Mali-T880 computes with vectors of four. The eighth tap counts nothing.
const vec2 tap1 = goldenTurn * vec2(1.0 / 6.0, 0.0), tap2 = goldenTurn * tap1, tap3 = goldenTurn * tap2;
const vec2 tap4 = goldenTurn * tap3, tap5 = goldenTurn * tap4, tap6 = goldenTurn * tap5;
const vec4 innerX = vec4(0.0, tap1.x, 2.0 * tap2.x, 3.0 * tap3.x);
const vec4 innerY = vec4(0.0, tap1.y, 2.0 * tap2.y, 3.0 * tap3.y);
const vec4 perInnerRadius = vec4(1e6, 6.0, 3.0, 2.0);
const vec4 outerX = vec4(4.0 * tap4.x, 5.0 * tap5.x, 6.0 * tap6.x, 0.0);
const vec4 outerY = vec4(4.0 * tap4.y, 5.0 * tap5.y, 6.0 * tap6.y, 0.0);
const vec4 perOuterRadius = vec4(1.5, 1.2, 1.0, 0.0);

// Adds four taps to the search, as addTap() does. `toNearPlane`: radius of the cone at the near plane.
void addTaps(inout BlockerSearch search, float receiver, float toNearPlane, vec3 onPlane, vec3 stepX,
             vec3 stepY, vec4 x, vec4 y, vec4 perRadius) {
    vec4 steps = vec4(stepX.x, stepY.y, stepX.x, stepY.y);
    vec4 ab = onPlane.xyxy + steps * vec4(x.x, y.x, x.y, y.y);
    vec4 cd = onPlane.xyxy + steps * vec4(x.z, y.z, x.w, y.w);
    vec4 plane = onPlane.z + stepX.z * x + stepY.z * y;
    vec4 depth = vec4(textureLod(shadowDepth, ab.xy, 0.0).r, textureLod(shadowDepth, ab.zw, 0.0).r,
                      textureLod(shadowDepth, cd.xy, 0.0).r, textureLod(shadowDepth, cd.zw, 0.0).r);
    vec4 penumbra = mix(vec4(0.0), (receiver - depth) / toNearPlane, lessThan(depth, plane));
    vec4 within = clamp(penumbra * perRadius, 0.0, 1.0);
    within *= within;
    search.weight += dot(within, vec4(1.0));
    search.weightPerPenumbra += dot(within, 1.0 / max(penumbra, 1e-6));
}

// The visible share of the sun's disc, for a surface that faces the disc's centre. At grazing light the
// surface's own horizon hides up to half of the disc, which n.l is left to account for.
//
// Lengths across the light are in units of the sun's cone: a blocker at radius 1 is within the cone if it is
// nearer to the light than the receiver by at least 1, in units of the map's depth. `slackShare`: flatSlack
// or curvedSlack.
float softShadow(vec3 positionVolume, vec3 normal, float slackShare) {
    SunMap map = sunMapAt(positionVolume);
    vec3 receiver = inSunMap(map, positionVolume);
    vec2 mapFromCone = map.coneRadius;

    // The slope of the receiver's plane: depth per length across the light.
    const float roundingBias = 1e-4;  // as in shadow.glsl
    vec3 across = mat3(frame.shadowSlopeFromNormal) * normal;
    vec2 slope = -across.xy / across.z;
    float perSteepness = inversesqrt(max(dot(slope, slope), 1e-12));
    vec2 downhill = slope * perSteepness;
    slope *= min(1.0, frame.steepestShadowSlope * perSteepness);
    // A comparison reads texels up to one texel away in each axis.
    vec2 texel = map.coneTexel;
    float size = float(textureSize(shadowDepth, 0).x);  // the map is a square
    float rise = dot(abs(slope), texel);
    float bias = rise + roundingBias;

    // A point of the receiver's plane in the map, and the plane's steps along the two axes across the light.
    vec3 onPlane = vec3(receiver.xy, receiver.z - bias);
    vec3 stepX = vec3(mapFromCone.x, 0.0, slope.x);
    vec3 stepY = vec3(0.0, mapFromCone.y, slope.y);

    // Compares the four texels around the receiver with its plane, as in shadow.glsl. In a crease the blocker
    // touches the receiver. Taps with a bias would pass over it, or see the outside beyond the border of the
    // surface.
    ShadowFootprint four =
        shadowFootprint(textureGather(shadowDepth, footprintCorner(receiver.xy, vec2(size))), receiver,
                        vec2(size), slope * texel, bias);
    float farthest = max(max(four.above.x, four.above.y), max(four.above.z, four.above.w));
    // A blocker farther away has a penumbra wider than a texel, and is no problem in a crease.
    bool touching = four.closest > -texel.x;
    // The bias hides a blocker that touches the receiver in a crease. The hard shadow has none, and decides
    // where no blocker was found or the penumbra is narrower than a texel.
    bool isDark = isHardShadow(four, farthest, receiver, vec2(size), slope * texel,
                               slackShare * (rise + 0.25 / size) + depthRounding);
    // The receiver is at the border of its surface, or all four texels are so little nearer that the bias
    // would hide the blocker. The wall that shades a crease is on the side that the normal points to, which
    // is down the slope. The taps are moved there, by the reach of a tap's filter and one texel more. They
    // stay on the plane, so this changes nothing if the plane is lit. In a lit crease one of the texels is
    // the surface itself, up to rounding.
    const float gridRounding = 0.01;  // rounding of corners, relative to the plane's rise over a tap's filter
    const float borderShare = 0.5;  // relative to the bias; a round surface of flat triangles is off by less
    const float aside = 2.0;        // texels
    if (touching && (farthest > borderShare * bias || farthest < -gridRounding * rise - depthRounding))
        onPlane += (stepX * downhill.x + stepY * downhill.y) * (aside * texel.x);

    // Blockers may be anywhere between the receiver and the map's near plane.
    float toNearPlane = max(receiver.z, 1e-6);
    stepX *= toNearPlane;
    stepY *= toNearPlane;
    BlockerSearch search = BlockerSearch(0.0, 0.0);
    addTaps(search, receiver.z, toNearPlane, onPlane, stepX, stepY, innerX, innerY, perInnerRadius);
    addTaps(search, receiver.z, toNearPlane, onPlane, stepX, stepY, outerX, outerY, perOuterRadius);
    float coneInTexels = toNearPlane / min(texel.x, texel.y);
    if (touching && farthest < -bias || search.weight == 0.0 && isDark) return 0.0;
    float penumbra;
    if (search.weight > 0.0) {
        penumbra = penumbraWidth(search);
    } else {
        // A thin blocker can be between the texels of the search, but the moments around the cone's axis
        // include it. They are assumed to be of one blocker and the receiver. On a slope, half of the
        // receiver itself is nearer too.
        vec2 moments = textureLod(shadowMoments, onPlane.xy, log2(max(0.25 * coneInTexels, 1.0))).rg;
        float nearer = (onPlane.z - momentMiddle - momentRounding) * momentUnit - moments.x;
        const float minShare = 0.001;
        if (nearer <= max(sqrt(minShare * moments.y), 0.25 * momentUnit * rise * coneInTexels)) return 1.0;
        penumbra = min((nearer + moments.y / nearer) / (momentUnit * toNearPlane), 1.0);
    }

    // Each tap reads the moments at a level with a filter half as wide as the penumbra's radius R, so that
    // four taps leave no gaps and the middle of the disc has the most weight. The distance of the taps from
    // the middle is chosen so that the variance of the whole kernel is that of a disc, R^2/4. The variance of
    // the filter alone is .42 wide^2.
    float radius = penumbra * coneInTexels;
    float wide = clamp(0.5 * radius, 2.0, size / (cascades == 1 ? 16.0 : 32.0));  // in texels of the map
    float level = log2(0.5 * wide);
    float relativeWidth = wide / max(radius, 1e-6);
    float distance =
        sqrt(max(0.6 - 0.835 * relativeWidth * relativeWidth, 0.25 * relativeWidth * relativeWidth));
    distance = min(distance, 0.7) * penumbra;
    // Only blockers within the cone count, to exclude a wall that rises from the receiver's plane. The full
    // cone would also exclude blockers that are nearer to the receiver than their mean.
    const float coneShare = 0.1;
    vec3 middle = vec3(onPlane.xy, onPlane.z - coneShare * toNearPlane * distance);
    vec4 light = vec4(0.0);
    float compared = 0.0;
    for (int i = 0; i < VCT_FILTER_TAPS / 4; ++i) {
        COUNT(VCT_COUNTER_FILTER_TAP);
        float angle = radians(90.0) * (0.25 + float(i) / float(VCT_FILTER_TAPS / 4));
        vec3 x = (stepX * cos(angle) + stepY * sin(angle)) * distance;
        vec3 y = (stepY * cos(angle) - stepX * sin(angle)) * distance;
        vec3 a = middle + x, b = middle + y, c = middle - x, d = middle - y;
        compared +=
            texture(shadowMap, a) + texture(shadowMap, b) + texture(shadowMap, c) + texture(shadowMap, d);
        vec2 momentsA = textureLod(shadowMoments, a.xy, level).rg,
             momentsB = textureLod(shadowMoments, b.xy, level).rg;
        vec2 momentsC = textureLod(shadowMoments, c.xy, level).rg,
             momentsD = textureLod(shadowMoments, d.xy, level).rg;
        vec4 plane = (vec4(a.z, b.z, c.z, d.z) - (momentMiddle + momentRounding)) * momentUnit;
        vec4 nearer = min(vec4(momentsA.x, momentsB.x, momentsC.x, momentsD.x) - plane, 0.0);
        vec4 variance = vec4(momentsA.y, momentsB.y, momentsC.y, momentsD.y);
        // Chebyshev's bound. It is exact if one blocker covers any share of one receiver.
        light += variance / (variance + nearer * nearer);
    }
    // A slanted blocker has a variance of its own, for which the bound lets some light through.
    const float bleeding = 0.02;
    light = light * (1.0 + bleeding) - 0.25 * bleeding * float(VCT_FILTER_TAPS);
    const float tapShare = 1.0 / float(VCT_FILTER_TAPS);
    float seen = compared * tapShare;
    if (isDark) seen *= clamp(radius - 1.0, 0.0, 1.0);
    // The comparisons limit the bound, which is too bright where a steep blocker touches the receiver, as at
    // a fold. So few of them, on a ring, miss up to this share of a disc that a straight edge covers.
    const float ringError = 0.25;
    float bound = min(dot(light, vec4(tapShare)), seen + ringError);
    // A penumbra of a few texels uses the map itself, because the finest level of the moments is already as
    // wide, and would reach too far beyond the border of the surface in a crease.
    return max(mix(seen, bound, clamp(0.5 * radius - 0.875, 0.0, 1.0)), 0.0);
}
