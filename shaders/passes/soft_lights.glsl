// Shadows of punctual lights with a size, out of their maps. The filter compares the maps' texels: these maps have no moments.
// A point or spot is a sphere, which is a disc that faces the receiver; a directional light is a disc at the sky, as the sun is.
// Taps are places beside the receiver, and each is looked up in the map that shows it, so a penumbra goes on from one side of a
// cube to the next.
//
// "Nearness" is how far what blocks the light is from the receiver on the way to the light: its distance from the receiver over
// that from a light that has a place, and its distance, in sides of the volume, for one that has none. The disc seen past
// it covers nearness times the light's size around the receiver; depths in the map are proportional to it, but for a constant.
#include "shared/counters.glsl"

const int sourceSearchTaps = 16;
const int sourceFilterTaps = 32;  // a penumbra of more texels has steps of as many parts of the light

// A place beside the receiver as the light's map has it.
struct Beside {
    vec3 inMap;           // texture coordinates and layer
    float depth;          // in the map, of the receiver's plane there
    float perDepth;       // nearness over depth in the map
    vec2 fromReceiver;    // scale and offset that make nearness to the receiver of nearness to its plane there
    float least;          // nearness up to which it may be the plane itself
};

Beside besideReceiver(int i, vec3 position, vec3 normal, vec3 aside) {
    vec4 place = punctual.light[i].position;
    vec3 beside = position + aside;
    vec3 away = beside * place.w - place.xyz;
    float distance = length(away);
    // The receiver's plane there. Towards its horizon it is as far away as is of any matter.
    float cosine = max(-dot(normal, away) / distance, 0.02);
    float along = clamp(dot(normal, aside) / (cosine * distance), -0.9, 8.0);
    ivec4 maps = punctual.light[i].maps;
    int layer = maps.x + (maps.y > 1 ? cubeFace(away) : 0);
    LightMap map = punctual.map[layer];
    vec4 projected = map.mapFromVolume * vec4(beside + away * along, 1.0);
    vec3 inMap = projected.xyz / projected.w;
    // Half a texel to where a texel's depth is of, and one to the filter's others.
    const float roundedPosition = 1e-4;  // in sides of the volume, as for the hard shadow
    const float roundedDepth = 1e-6;
    float perDepth = projected.w / map.depth.y;
    float rising = sqrt(1.0 / (cosine * cosine) - 1.0);
    float least = 4.0 * map.depth.x / map.depth.y * (1.5 * rising + 0.5) + roundedPosition * (1.0 + rising) / distance +
                  roundedDepth * perDepth;
    float scale = 1.0 / (1.0 + along * place.w);
    return Beside(vec3(inMap.xy, layer), inMap.z, perDepth, vec2(scale, -along * scale), least);
}

// Share of a light with a size that a surface sees. `hard`: the answer of the map's texels around it
// (shadowFootprintLight()), `texel`: the width of one there, in sides of the volume, `nearestMap`: nearness of the map's near
// plane.
float softVisibility(int i, vec3 position, vec3 normal, vec3 towards, float hard, float texel, float nearestMap) {
    PunctualLightUniforms light = punctual.light[i];
    float size = light.cone.z;
    // The largest penumbra. Blockers nearer to a lamp than an eighth of the way, or than four times its radius, leave one that
    // is too narrow: in the middle of a side of a cube this is a quarter of it.
    float distance = length(position * light.position.w - light.position.xyz);
    float reach = size * nearestMap;
    if (light.position.w > 0.0) reach = min(reach, min(7.0 * size, 0.25 * distance));
    mat3 across = frameAround(towards);

    // Places close to each other in the middle: blockers may be anywhere on the way, and those close to the receiver
    // leave a narrow penumbra.
    BlockerSearch search = BlockerSearch(0.0, 0.0);
    vec2 direction = vec2(1.0, 0.0);
    for (int tap = 0; tap < sourceSearchTaps; ++tap) {
        COUNT(VCT_COUNTER_BLOCKER_TAP);
        float radius = float(tap) / float(sourceSearchTaps - 1);
        radius *= radius * reach;
        Beside there = besideReceiver(i, position, normal, radius * (across[0] * direction.x + across[2] * direction.y));
        float nearness = (there.depth - textureLod(lightMaps, there.inMap, 0.0).r) * there.perDepth;
        float penumbra = (nearness * there.fromReceiver.x + there.fromReceiver.y) * size;
        addTap(search, nearness > there.least ? penumbra : 0.0, radius);
        direction = goldenTurn * direction;
    }
    // What touches the receiver is the hard shadow's.
    if (search.weight == 0.0) return hard;
    float penumbra = min(penumbraOf(search), reach);
    float share = clamp(0.5 * penumbra / texel - 0.5, 0.0, 1.0);
    if (share == 0.0) return hard;

    // Blockers are in the cone, which a wall that rises from the receiver's plane is not. The whole cone would leave out those
    // that are nearer than their mean.
    const float coneShare = 0.5;
    vec2 mapSize = vec2(textureSize(lightMaps, 0).xy);
    float seen = 0.0;
    for (int tap = 0; tap < sourceFilterTaps; ++tap) {
        COUNT(VCT_COUNTER_FILTER_TAP);
        float radius = penumbra * sqrt((float(tap) + 0.5) / float(sourceFilterTaps));
        Beside there = besideReceiver(i, position, normal, radius * (across[0] * direction.x + across[2] * direction.y));
        vec3 corner = vec3(footprintCorner(there.inMap.xy, mapSize), there.inMap.z);
        vec4 nearness = (there.depth - textureGather(lightMaps, corner)) * there.perDepth;
        vec4 cone = (nearness * there.fromReceiver.x + there.fromReceiver.y) * size;
        vec4 blocked = vec4(greaterThan(nearness, vec4(there.least))) * vec4(greaterThan(cone, vec4(coneShare * radius)));
        seen += 1.0 - filterFootprint(blocked, fract(there.inMap.xy * mapSize - 0.5));
        direction = goldenTurn * direction;
    }
    return mix(hard, seen / float(sourceFilterTaps), share);
}
