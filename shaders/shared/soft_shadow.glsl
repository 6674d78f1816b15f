// The shadow of a sun with a size, out of the shadow map: percentage-closer soft shadows (Fernando 2005) for a
// directional light. A search for what blocks the sun gives the width of the penumbra, over which the map is then
// compared. Reads VCT_BLOCKER_TAPS plain depths and, where there is a blocker, VCT_FILTER_TAPS compared ones.
#include "shared/shadow.glsl"
#include "shared/trips.glsl"

layout(binding = VCT_TEX_SHADOW_DEPTH) uniform sampler2D shadowDepth;  // the same map, not compared

// From one sample of a Vogel disc (1979) to the next: the golden angle.
const mat2 goldenTurn = mat2(-0.7373688, 0.6754903, -0.6754903, -0.7373688);

// Share of the sun's disc that a point sees. 0 where the surface faces away from the disc's centre; that the
// horizon of a surface at grazing light hides up to half of the disc is left to n.l.
//
// Lengths across the light are in units of the sun's cone: at 1, a blocker must be 1 nearer to the light, in units
// of the map's depth, to be within the cone.
float softShadow(vec3 positionVolume, vec3 normal) {
    if (dot(normal, frame.towardsLight.xyz) <= 0.0) return 0.0;
    vec3 receiver = (frame.shadowFromVolume * vec4(positionVolume, 1.0)).xyz;
    vec2 mapFromCone = frame.cone.zw;

    // The receiver's plane: depth per length across the light. Rows of the matrix are the map's axes; mapFromCone
    // is tan(half angle) times the ratio of their lengths.
    const float steepest = 64.0;      // the light less than a degree above the surface: n.l is below 1/64
    const float roundingBias = 1e-4;  // as in shadow.glsl
    float sine2 = frame.cone.x * frame.cone.x;
    float tan2 = sine2 / (1.0 - sine2);
    vec3 across = mat3(frame.shadowFromVolume) * normal;
    vec2 slope = -across.xy / across.z * tan2 / mapFromCone;
    slope *= min(1.0, steepest * sqrt(tan2) * inversesqrt(max(dot(slope, slope), 1e-12)));
    // A comparison reads texels up to one texel away in each axis.
    vec2 texel = 1.0 / (vec2(textureSize(shadowDepth, 0)) * mapFromCone);
    float depth = receiver.z - dot(abs(slope), texel) - roundingBias;

    // Blockers may be anywhere between the receiver and the map's near plane. Linear radii: those close to the
    // receiver are within the cone near its axis only.
    float blockers = 0.0;
    float nearer = 0.0;
    vec2 direction = vec2(1.0, 0.0);
    for (int i = 0; i < VCT_BLOCKER_TAPS; ++i) {
        TRIP(VCT_TRIPS_BLOCKER_TAP);
        float radius = receiver.z * float(i) / float(max(VCT_BLOCKER_TAPS - 1, 1));
        vec2 offset = radius * direction;
        float blocker = textureLod(shadowDepth, receiver.xy + mapFromCone * offset, 0.0).r;
        if (blocker < depth + dot(slope, offset)) {
            // What is beside the cone does not block; it only tells of an edge that the other taps have missed.
            float distance = max(receiver.z - blocker, 0.0);
            float within = min(distance / max(radius, 1e-6), 1.0);
            blockers += within * within;
            nearer += within * within * distance;
        }
        direction = goldenTurn * direction;
    }
    if (blockers == 0.0) return 1.0;

    float penumbra = nearer / blockers;
    float light = 0.0;
    direction = vec2(1.0, 0.0);
    for (int i = 0; i < VCT_FILTER_TAPS; ++i) {
        TRIP(VCT_TRIPS_FILTER_TAP);
        vec2 offset = penumbra * sqrt((float(i) + 0.5) / float(VCT_FILTER_TAPS)) * direction;
        light += textureLod(shadowMap, vec3(receiver.xy + mapFromCone * offset, depth + dot(slope, offset)), 0.0);
        direction = goldenTurn * direction;
    }
    return light / float(VCT_FILTER_TAPS);
}
