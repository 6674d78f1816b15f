// Soft shadows of punctual lights from their maps. These maps have no coarser levels, so the filter compares
// single texels.
// A point or spot light is a sphere, seen as a disc from the receiver; a directional light is a disc in the
// sky, as the sun is. Taps are positions beside the receiver. Each is looked up in the map that shows it, so
// that penumbrae continue from one face of a cube to the next.
//
// The "nearness" of a blocker is the penumbra that it leaves, divided by the light's size. For point and spot
// lights it is the blocker's distance from the receiver divided by its distance from the light; for
// directional lights it is the distance from the receiver in sides of the volume. Depths in the map are
// proportional to it, up to a constant.
#include "shared/layout.h"

const int sourceSearchTaps = 16;
const int sourceFilterTaps = 32;  // penumbrae wider than so many texels show steps of 1/32

// A position beside the receiver, in the light's map.
struct Beside {
    vec3 inMap;         // texture coordinates and layer
    float depth;        // depth of the receiver's plane at this position
    float perDepth;     // nearness per depth in the map
    vec2 fromReceiver;  // scale and offset from nearness to the plane here to nearness to the receiver
    float least;        // largest nearness of a texel that may be the plane itself
};

Beside projectTap(int i, vec3 position, vec3 normal, vec3 aside) {
    vec4 place = punctual.light[i].position;
    vec3 beside = position + aside;
    vec3 away = beside * place.w - place.xyz;
    float distance = length(away);
    // The distance to the receiver's plane along the ray. It is limited towards the plane's horizon.
    float cosine = max(-dot(normal, away) / distance, 0.02);
    float along = clamp(dot(normal, aside) / (cosine * distance), -0.9, 8.0);
    ivec4 maps = punctual.light[i].maps;
    int layer = maps.x + (maps.y > 1 ? cubeFace(away) : 0);
    LightMap map = punctual.map[layer];
    vec4 projected = map.mapFromVolume * vec4(beside + away * along, 1.0);
    vec3 inMap = projected.xyz / projected.w;
    // A texel's depth is up to half a texel off, and the filter reads up to one texel farther.
    const float roundedDepth = 1e-6;
    float perDepth = projected.w / map.depth.y;
    float rising = sqrt(1.0 / (cosine * cosine) - 1.0);
    float least = 4.0 * map.depth.x / map.depth.y * (1.5 * rising + 0.5) +
                  map.depth.w * (1.0 + rising) / distance + roundedDepth * perDepth;
    float scale = 1.0 / (1.0 + along * place.w);
    return Beside(vec3(inMap.xy, layer), inMap.z, perDepth, vec2(scale, -along * scale), least);
}

// The visible share of a light's disc. `hard`: the hard shadow (shadowFootprintLight()). `texel`: width of a
// texel at the receiver, in sides of the volume. `nearestMap`: nearness of the map's near plane.
float softVisibility(int i, vec3 position, vec3 normal, vec3 towards, float hard, float texel,
                     float nearestMap) {
    PunctualLightUniforms light = punctual.light[i];
    float size = light.cone.z;
    // The largest penumbra, in sides of the volume. Blockers nearer to the light than an eighth of the
    // distance, or than four times its radius, get a penumbra that is too narrow.
    float distance = length(position * light.position.w - light.position.xyz);
    float reach = size * nearestMap;
    if (light.position.w > 0.0) reach = min(reach, min(7.0 * size, 0.25 * distance));
    mat3 across = frameAround(towards);

    // Taps are denser in the middle, because blockers close to the receiver have narrow penumbrae.
    BlockerSearch search = BlockerSearch(0.0, 0.0);
    vec2 direction = vec2(1.0, 0.0);
    for (int tap = 0; tap < sourceSearchTaps; ++tap) {
        float radius = float(tap) / float(sourceSearchTaps - 1);
        radius *= radius * reach;
        Beside there =
            projectTap(i, position, normal, radius * (across[0] * direction.x + across[2] * direction.y));
        vec4 depth =
            projectedDepths(textureLod(lightMaps, there.inMap, 0.0).rrrr, punctual.map[int(there.inMap.z)]);
        float nearness = (there.depth - depth.r) * there.perDepth;
        float penumbra = (nearness * there.fromReceiver.x + there.fromReceiver.y) * size;
        addTap(search, nearness > there.least ? penumbra : 0.0, radius);
        direction = goldenTurn * direction;
    }
    // Blockers that touch the receiver are left to the hard shadow.
    if (search.weight == 0.0) return hard;
    float penumbra = min(penumbraWidth(search), reach);
    float share = clamp(0.5 * penumbra / texel - 0.5, 0.0, 1.0);
    if (share == 0.0) return hard;

    // Only blockers within the cone count, to exclude a wall that rises from the receiver's plane. The full
    // cone would also exclude blockers that are nearer to the receiver than their mean.
    const float coneShare = 0.5;
    vec2 mapSize = vec2(textureSize(lightMaps, 0).xy);
    float seen = 0.0;
    for (int tap = 0; tap < sourceFilterTaps; ++tap) {
        float radius = penumbra * sqrt((float(tap) + 0.5) / float(sourceFilterTaps));
        Beside there =
            projectTap(i, position, normal, radius * (across[0] * direction.x + across[2] * direction.y));
        vec3 corner = vec3(footprintCorner(there.inMap.xy, mapSize), there.inMap.z);
        vec4 depths = projectedDepths(textureGather(lightMaps, corner), punctual.map[int(there.inMap.z)]);
        vec4 nearness = (there.depth - depths) * there.perDepth;
        vec4 cone = (nearness * there.fromReceiver.x + there.fromReceiver.y) * size;
        vec4 blocked = vec4(greaterThan(nearness, vec4(there.least))) *
                       vec4(greaterThan(cone, vec4(coneShare * radius)));
        seen += 1.0 - filterFootprint(blocked, fract(there.inMap.xy * mapSize - 0.5));
        direction = goldenTurn * direction;
    }
    return mix(hard, seen / float(sourceFilterTaps), share);
}
