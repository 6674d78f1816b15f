// The sun's soft shadow by percentage-closer soft shadows (Fernando 2005): a search for blockers gives the
// width of the penumbra, over which comparisons with the shadow map are averaged. It reads the hard shadow's
// five texels, eight more depths, and eight comparisons, or 16 in a penumbra and 48 in its dark half. A wide
// penumbra compares with coarser levels of the map (passes/shadow_level.frag), so that a few comparisons
// leave no gaps and the cost does not grow with the width. Behind a straight edge, the root mean square error
// in a penumbra is below 0.06 of the sun's light on a plane and 0.08 on a ball
// (tests/engine/soft_shadow_test.cpp).
#include "shared/shadow.glsl"

// The taps of the search, in vectors of four, with which a Mali-T880 computes. The inner ones find thin
// blockers. Their radii grow by more than those of a uniform disc, because blockers close to the receiver are
// within the cone only near its axis. The outer ones are the corners of a square around the cone, so that the
// search finds each straight edge that reaches into the cone.
const vec4 innerRadius = vec4(0.0057, 0.1, 0.28, 0.58);
const vec4 innerX = innerRadius * vec4(1.0, -0.7373, 0.0872, 0.6088);
const vec4 innerY = innerRadius * vec4(0.0, 0.6756, -0.9962, 0.7934);
const float outerRadius = 1.4142;
const vec4 outerX = outerRadius * vec4(0.9848, -0.1736, -0.9848, 0.1736);
const vec4 outerY = outerX.wxyz;

// The penumbrae that blockers at four taps leave, negative where nothing is above the receiver's plane.
// Lengths are in radii of the sun's cone at the map's near plane. `plane`: the slope, and the distance to the
// near plane.
vec4 penumbraeAt(vec4 x, vec4 y, vec2 receiver, vec2 cone, vec3 plane, float perDepth) {
    vec4 v = y + frame.shadowShear * x;
    vec4 ab = receiver.xyxy + cone.xyxy * vec4(x.x, v.x, x.y, v.y);
    vec4 cd = receiver.xyxy + cone.xyxy * vec4(x.z, v.z, x.w, v.w);
    vec4 depth = vec4(textureLod(shadowDepth, ab.xy, 0.0).r, textureLod(shadowDepth, ab.zw, 0.0).r,
                      textureLod(shadowDepth, cd.xy, 0.0).r, textureLod(shadowDepth, cd.zw, 0.0).r);
    return plane.z + min(plane.x * x + plane.y * y, 0.0) - perDepth * depth;
}

const int filterTaps = 16;
const vec2 outerCircles = vec2(0.9354, 0.7906), innerCircles = vec2(0.6124, 0.3536);  // of equal shares

// The first comparison, relative to the penumbra's radius, and the turn to the next circle: the golden ratio
// of a quarter. The filter of a comparison widens the whole by 4 %.
const vec2 firstTap = 0.96 * vec2(-0.5825879, 0.8127677);
const mat2 goldenQuarter = mat2(0.8253344, -0.5646442, 0.5646442, 0.8253344);

float comparisons(vec3 middle, vec3 a, vec3 b, float level) {
    vec3 p = middle + a, q = middle - a, r = middle + b, s = middle - b;
    return textureLod(shadowMap, p, level) + textureLod(shadowMap, q, level) +
           textureLod(shadowMap, r, level) + textureLod(shadowMap, s, level);
}

// The visible share of the sun's disc, for a surface that faces the disc's centre. At grazing light the
// surface's own horizon hides up to half of the disc, which n.l is left to account for. `slackShare`:
// flatSlack or curvedSlack.
float softShadow(vec3 positionVolume, vec3 normal, float slackShare) {
    SunMap map = sunMapAt(positionVolume);
    vec3 receiver = inSunMap(map, positionVolume);

    vec2 slope = coneSlope(normal), slopePerTexel = shadowSlope(map, slope);
    vec2 texel = map.coneTexel;
    vec2 size = vec2(textureSize(shadowDepth, 0));
    float rise = abs(slopePerTexel.x) + abs(slopePerTexel.y);

    // A bias hides blockers that touch the receiver, as in a crease, and beyond the border of a surface taps
    // see the outside. The hard shadow has no bias. It decides where a blocker is so near that its penumbra
    // is narrower than a texel.
    float nearest;
    float slack = slackShare * (rise + 0.25 / size.x) + depthRounding;
    bool isDark = isHardShadow(receiver, size, slopePerTexel, slack, nearest);
    if (isDark && nearest > -texel.x) return 0.0;

    // Blockers may be anywhere between the receiver and the map's near plane. With cascades they are searched
    // as far away as the tile holds the penumbra, and the filter's texels, which are up to half as wide as
    // its radius.
    const float roundingBias = 1e-4;  // as in shadow.glsl
    float reach = max(receiver.z, 1e-6);
    if (cascades > 1) {
        vec2 toBorder = (0.25 - abs(0.5 * fract(2.0 * receiver.xy) - 0.25)) / map.coneRadius;
        reach = min(reach, min(toBorder.x, toBorder.y) / 1.5);
    }
    float perDepth = 1.0 / reach;
    vec2 cone = map.coneRadius * reach;
    vec3 plane = vec3(slope, (receiver.z - rise - roundingBias) * perDepth);
    vec4 inner = penumbraeAt(innerX, innerY, receiver.xy, cone, plane, perDepth);
    vec4 outer = penumbraeAt(outerX, outerY, receiver.xy, cone, plane, perDepth);
    // A blocker outside of the cone does not block. It counts less, but shows an edge that other taps may
    // miss. The nearer of two blockers decides: a penumbra that is too wide leaks light into the creases of a
    // room.
    vec4 innerWeight = clamp(inner / innerRadius, 0.0, 1.0) * (1.0 - inner);
    vec4 outerWeight = clamp(outer / outerRadius, 0.0, 1.0) * (1.0 - outer);
    innerWeight *= innerWeight;
    outerWeight *= outerWeight;
    float weight = dot(innerWeight + outerWeight, vec4(1.0));
    bool isInMap = all(lessThan(abs(receiver.xy - 0.5) + cone, vec2(0.5)));
    if (weight == 0.0 && (isDark || !isInMap)) return isDark ? 0.0 : 1.0;
    float penumbra = reach * min(dot(innerWeight * inner + outerWeight * outer, vec4(1.0)) / weight, 1.0);
    // The search's bias hides blockers above a surface that the sun grazes. The hard shadow has none. A thin
    // blocker can be between the taps of the search. The comparisons over the whole cone meet it. Beyond the
    // map's border they would meet the surface itself.
    bool isFound = weight > 0.0 || nearest < -slack;
    if (weight == 0.0) penumbra = isFound ? min(-nearest, reach) : reach;
    // Only blockers within the cone count, to exclude a wall that rises from the receiver's plane. The full
    // cone would also exclude blockers that are nearer to the receiver than their mean.
    float inCone = isFound ? 0.09 * penumbra : penumbra;

    // Texels of the levels around this one are a fifth of the penumbra's radius wide, so that neighbouring
    // comparisons overlap. A comparison reads up to one and a half of them away along each axis.
    float radius = penumbra / min(texel.x, texel.y);  // in texels
    float texels = max(0.2 * radius, 1.0);
    float lift = min(1.5 * texels * rise, max(3.3 * inCone, 0.05 * reach));
    float level = log2(texels);
    vec3 middle = vec3(receiver.xy, receiver.z - lift - roundingBias);
    vec3 stepX = vec3(map.coneRadius.x, map.coneRadius.y * frame.shadowShear, slope.x) * penumbra;
    vec3 stepY = vec3(0.0, map.coneRadius.y, slope.y) * penumbra;
    // A wall that is parallel to the sun hides a part of it along its crease, but the map shows of that wall
    // at most its foot. Taps see past it, or the foot is not within the cone and counts as light. So in the
    // hard shadow two more pairs of rounds look for the plane itself in light, without the cone. The second
    // compares with depths behind the plane, further than a relief and the levels' texels rise, and finds the
    // taps that see past the plane's border. A curved surface bends away from its plane, so there such taps
    // are right.
    bool hasSides = isDark && slackShare < curvedSlack;
    float light = 0.0, sum = 0.0, onPlane = 0.0, past = 0.0;
    vec2 tap = firstTap, circles = outerCircles;
    int rounds = hasSides ? 6 : 2;
    for (int round = 0; round < rounds; ++round) {
        // Four comparisons on each of two circles, a quarter turn apart.
        vec2 at = tap * circles.x;
        vec3 a = stepX * at.x + stepY * at.y, b = stepY * at.x - stepX * at.y;
        vec3 raised = vec3(middle.xy, middle.z - inCone * circles.x);
        sum += comparisons(raised, a, b, level);
        tap = goldenQuarter * tap;
        at = tap * circles.y;
        a = stepX * at.x + stepY * at.y, b = stepY * at.x - stepX * at.y;
        raised.z += inCone * (circles.x - circles.y);
        sum += comparisons(raised, a, b, level);
        tap = goldenQuarter * tap;
        // The outer circles leave few gaps along the border of the disc. If they agree with the hard shadow,
        // so do the inner ones.
        if (round == 0 && sum == (isDark ? 0.0 : 8.0)) {
            light = 2.0 * sum;
            break;
        }
        circles = innerCircles;
        if ((round & 1) == 0) continue;
        if (round == 1) light = sum;
        if (round == 3) onPlane = sum;
        if (round == 5) past = sum;
        if (sum == 0.0) break;
        sum = 0.0;
        tap = firstTap;
        circles = outerCircles;
        inCone = 0.0;
        middle.z = receiver.z + (round == 1 ? -0.75 * texels * rise - roundingBias
                                            : 1.5 * texels * rise + 0.5 * map.coneRadius.x * penumbra);
    }
    // Light counts as far as a third of it is on the plane.
    if (hasSides) light = min(light, max(3.0 * (onPlane - past - min(past, 1.0)), 0.0));
    light *= 1.0 / float(filterTaps);
    return isDark ? light * clamp(radius - 1.0, 0.0, 1.0) : light;
}
