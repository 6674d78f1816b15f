// The shadow of a sun with a size, out of the shadow map. The filter reads the map's moments (shared/moments.glsl), as
// variance shadow maps do (Donnelly and Lauritzen 2006). Reads the hard shadow's four texels, blockerTaps plain depths and,
// where something blocks, VCT_FILTER_TAPS places of two levels of the moments: the cost does not grow with the penumbra.
#include "shared/shadow.glsl"
#include "shared/moments.glsl"
#include "shared/counters.glsl"

layout(binding = VCT_TEX_SHADOW_MOMENTS) uniform highp sampler2D shadowMoments;

const int blockerTaps = 7;  // with 6 a penumbra has steps where the search loses its edge; 16 gain .001 in the courtyard

// Share of the sun's disc that a point sees. 0 where the surface faces away from the disc's centre; that the
// horizon of a surface at grazing light hides up to half of the disc is left to n.l.
//
// Lengths across the light are in units of the sun's cone: at 1, a blocker must be 1 nearer to the light, in units
// of the map's depth, to be within the cone.
float softShadow(vec3 positionVolume, vec3 normal) {
    if (dot(normal, frame.directionToLight.xyz) <= 0.0) return 0.0;
    vec3 receiver = (frame.shadowFromVolume * vec4(positionVolume, 1.0)).xyz;
    vec2 mapFromCone = frame.shadowConeRadius;

    // The receiver's plane: depth per length across the light. Rows of the matrix are the map's axes; mapFromCone
    // is tan(half angle) times the ratio of their lengths.
    const float steepest = 64.0;      // the light less than a degree above the surface: n.l is below 1/64
    const float roundingBias = 1e-4;  // as in shadow.glsl
    float sine2 = frame.shadowConeSine * frame.shadowConeSine;
    float tan2 = sine2 / (1.0 - sine2);
    vec3 across = mat3(frame.shadowFromVolume) * normal;
    vec2 coneFromMap = 1.0 / mapFromCone;
    vec2 slope = across.xy * (-tan2 / across.z) * coneFromMap;
    float perSteepness = inversesqrt(max(dot(slope, slope), 1e-12));
    vec2 downhill = slope * perSteepness;
    slope *= min(1.0, steepest * sqrt(tan2) * perSteepness);
    // A comparison reads texels up to one texel away in each axis.
    float size = float(textureSize(shadowDepth, 0).x);  // the map is a square
    vec2 texel = coneFromMap / size;
    float rise = dot(abs(slope), texel);
    float bias = rise + roundingBias;

    // A point of the receiver's plane as the map sees it, and its steps along the two axes across the light.
    vec3 onPlane = vec3(receiver.xy, receiver.z - bias);
    vec3 stepX = vec3(mapFromCone.x, 0.0, slope.x);
    vec3 stepY = vec3(0.0, mapFromCone.y, slope.y);

    // The four texels around the receiver, each against the plane where the texel is, as in shadow.glsl. In a crease what
    // blocks touches the receiver: the bias lifts the taps over it, and past the surface's border they see the outside.
    ShadowFootprint four = shadowFootprint(textureGather(shadowDepth, footprintCorner(receiver.xy, vec2(size))), receiver,
                                           vec2(size), slope * texel, bias);
    float farthest = max(max(four.above.x, four.above.y), max(four.above.z, four.above.w));
    // What is farther away has a penumbra wider than a texel's radius, and is no matter of the crease.
    bool touching = four.closest > -texel.x;
    if (touching && farthest < -bias) return 0.0;
    // Past the surface's border, or all four so little nearer that the bias would hide it. The wall that shades a crease
    // is seen where the surface's normal points, which is down its slope: the taps go there, as far as a tap's filter
    // reaches and one texel more. They stay on the plane, and where nothing blocks it moving them changes nothing. At a
    // crease that is lit a texel is the surface itself, but for what corners rounded to the rasterizer's grid make of it.
    const float gridRounding = 0.01;  // of what the plane rises over a tap's filter
    const float pastShare = 0.5;      // of the bias: a round surface drawn flat is off the plane by less
    const float aside = 2.0;          // in texels
    if (touching && (farthest > pastShare * bias || farthest < -gridRounding * rise - depthRounding))
        onPlane += (stepX * downhill.x + stepY * downhill.y) * (aside * texel.x);

    // Blockers may be anywhere between the receiver and the map's near plane. Linear radii: those close to the
    // receiver are within the cone near its axis only.
    float toNearPlane = max(receiver.z, 1e-6);
    stepX *= toNearPlane;
    stepY *= toNearPlane;
    BlockerSearch search = BlockerSearch(0.0, 0.0);
    vec2 direction = vec2(1.0, 0.0);
    for (int i = 0; i < blockerTaps; ++i) {
        COUNT(VCT_COUNTER_BLOCKER_TAP);
        float radius = float(i) / float(blockerTaps - 1);
        vec2 offset = radius * direction;
        vec3 at = onPlane + stepX * offset.x + stepY * offset.y;
        float blocker = textureLod(shadowDepth, at.xy, 0.0).r;
        addTap(search, blocker < at.z ? (receiver.z - blocker) / toNearPlane : 0.0, radius);
        direction = goldenTurn * direction;
    }
    float coneInTexels = toNearPlane * max(mapFromCone.x, mapFromCone.y) * size;
    float penumbra;
    if (search.weight > 0.0) {
        penumbra = penumbraOf(search);
    } else {
        // What is thin is between the search's texels, but in the moments around the cone's axis: of one blocker and the
        // receiver, which they tell apart. On a slope half of what is there is nearer; and at the map's border all.
        vec2 moments = textureLod(shadowMoments, onPlane.xy, log2(max(0.25 * coneInTexels, 1.0))).rg;
        float nearer = (onPlane.z - momentMiddle - momentRounding) * momentUnit - moments.x;
        const float leastShare = 0.001;
        if (nearer <= max(sqrt(leastShare * moments.y), 0.25 * momentUnit * rise * coneInTexels)) return 1.0;
        penumbra = min((nearer + moments.y / nearer) / (momentUnit * toNearPlane), 1.0);
    }

    // A place stands for what the moments' filter mixes there, half of the penumbra's radius wide: wide enough that four
    // places leave no gaps, and that what is in the middle of the disc weighs most. The places' distance makes up the
    // variance of the disc, R^2/4: that of the filter, .42 texels of its level, is .42 wide^2.
    float radius = penumbra * coneInTexels;
    float wide = clamp(0.5 * radius, 2.0, size / 16.0);  // texels of the map, up to one of the coarsest level
    float level = log2(0.5 * wide);
    float relativeWidth = wide / max(radius, 1e-6);
    float distance = sqrt(max(0.6 - 0.835 * relativeWidth * relativeWidth, 0.25 * relativeWidth * relativeWidth));
    distance = min(distance, 0.7) * penumbra;
    // Blockers are in the cone, which a wall that rises from the receiver's plane is not. The whole cone would leave out those
    // that are nearer than their mean.
    const float coneShare = 0.1;
    vec3 middle = vec3(onPlane.xy, onPlane.z - coneShare * toNearPlane * distance);
    vec4 light = vec4(0.0);
    vec4 compared = vec4(0.0);
    for (int i = 0; i < VCT_FILTER_TAPS / 4; ++i) {
        COUNT(VCT_COUNTER_FILTER_TAP);
        float angle = radians(90.0) * (0.25 + float(i) / float(VCT_FILTER_TAPS / 4));
        vec3 x = (stepX * cos(angle) + stepY * sin(angle)) * distance;
        vec3 y = (stepY * cos(angle) - stepX * sin(angle)) * distance;
        vec3 a = middle + x, b = middle + y, c = middle - x, d = middle - y;
        compared += vec4(texture(shadowMap, a), texture(shadowMap, b), texture(shadowMap, c), texture(shadowMap, d));
        vec2 momentsA = textureLod(shadowMoments, a.xy, level).rg, momentsB = textureLod(shadowMoments, b.xy, level).rg;
        vec2 momentsC = textureLod(shadowMoments, c.xy, level).rg, momentsD = textureLod(shadowMoments, d.xy, level).rg;
        vec4 plane = (vec4(a.z, b.z, c.z, d.z) - (momentMiddle + momentRounding)) * momentUnit;
        vec4 nearer = min(vec4(momentsA.x, momentsB.x, momentsC.x, momentsD.x) - plane, 0.0);
        vec4 variance = vec4(momentsA.y, momentsB.y, momentsC.y, momentsD.y);
        // Chebyshev's bound: exact where one blocker covers a part of a receiver, whatever its share.
        light += variance / (variance + nearer * nearer);
    }
    // A blocker that slants has a variance of its own, which the bound takes for light.
    const float bleeding = 0.02;
    light = light * (1.0 + bleeding) - 0.25 * bleeding * float(VCT_FILTER_TAPS);
    // A penumbra of a few texels is compared with the map itself: the moments' finest filter is as wide as that, and
    // past the surface's border looks too far for a crease.
    vec4 both = mix(compared, light, clamp(0.5 * radius - 0.875, 0.0, 1.0));
    return max(dot(both, vec4(1.0 / float(VCT_FILTER_TAPS))), 0.0);
}
