// Punctual lights: directional, point and spot (glTF's KHR_lights_punctual), and their shadow maps (layers of
// one texture, six for a point light). Edges of shadows are one texel wide, or have penumbrae with
// VCT_SOFT_LIGHTS.
#include "shared/shadow.glsl"
#include "shared/orthonormal.glsl"

layout(std140, binding = VCT_UBO_PUNCTUAL_LIGHTS) uniform PunctualLightsBlock {
    PunctualLightBlock punctual;
};
layout(binding = VCT_TEX_LIGHT_MAPS) uniform highp sampler2DArray lightMaps;

struct LightAt {
    vec3 towards;     // unit length
    vec3 irradiance;  // on a surface that faces the light, without shadow, relative to the sun's E
};

// Evaluates a light at a position in volume space: attenuation by distance, range and cone, as in the
// extension.
LightAt lightAt(int i, vec3 position) {
    PunctualLightUniforms light = punctual.light[i];
    vec3 offset = light.position.xyz - position * light.position.w;
    float squared = max(dot(offset, offset), 1e-12);
    vec3 towards = offset * inversesqrt(squared);
    float share = squared * light.backwards.w;
    float window = clamp(1.0 - share * share, 0.0, 1.0);
    float cone = clamp(dot(towards, light.backwards.xyz) * light.cone.x + light.cone.y, 0.0, 1.0);
    // A light may touch a surface, so the result is limited to the range of half floats.
    return LightAt(towards, min(light.intensity.rgb * (window * cone * cone / squared), 6e4));
}

// Index of the cube's map that shows a direction from the light: +x, -x, +y, -y, +z, -z.
int cubeFace(vec3 direction) {
    vec3 along = abs(direction);
    int axis = along.x >= along.y && along.x >= along.z ? 0 : along.y >= along.z ? 1 : 2;
    return 2 * axis + (direction[axis] < 0.0 ? 1 : 0);
}

// Depths of a map's projection, from those that the map stores (passes/light_map.vert).
vec4 projectedDepths(vec4 stored, LightMap map) {
    return map.depth.z == 0.0 ? stored : 1.0 + map.depth.z - map.depth.z / max(stored, 1e-5);
}

#ifdef VCT_SOFT_LIGHTS
#include "passes/soft_lights.glsl"
#endif

// As shadowFootprintLight() in shared/shadow.glsl, for a layer of the maps.
float shadowFootprintLight(LightMap map, int layer, vec3 receiver, vec2 slope, float slack) {
    vec2 size = vec2(textureSize(lightMaps, 0).xy);
    vec4 depths =
        projectedDepths(textureGather(lightMaps, vec3(footprintCorner(receiver.xy, size), layer)), map);
    ShadowFootprint four = shadowFootprint(depths, receiver, size, slope, slack);
    if (max(four.blockers, four.onPlane) == 4.0) return 0.25 * four.onPlane;
    vec2 next = tieBreakTexel(four, slope);
    vec4 nextDepth = projectedDepths(textureLod(lightMaps, vec3((next + 0.5) / size, layer), 0.0).rrrr, map);
    return edgeLight(four, nextDepth.r - receiver.z - dot(slope, next - four.texel), slack);
}

// Visibility of a light from a surface: 0 in shadow, 1 in light, and values between them at the edge of the
// shadow. As shadowMapLightOn() in shared/shadow.glsl, but for a projective map. `slackShare`: flatSlack to
// curvedSlack.
float punctualVisibility(int i, vec3 position, vec3 normal, vec3 towards, float slackShare) {
    if (dot(normal, towards) <= 0.0) return 0.0;
    ivec4 maps = punctual.light[i].maps;
    if (maps.y == 0) return 1.0;
    int layer = maps.x + (maps.y > 1 ? cubeFace(-towards) : 0);
    LightMap map = punctual.map[layer];
    vec4 projected = map.mapFromVolume * vec4(position, 1.0);
    float perW = 1.0 / projected.w;
    vec3 receiver = projected.xyz * perW;
    // The images of two tangents in the map give the slope of the surface's plane: depth per map coordinate.
    mat3 surface = frameAround(normal);
    vec4 stepA = map.mapFromVolume * vec4(surface[0], 0.0);
    vec4 stepB = map.mapFromVolume * vec4(surface[2], 0.0);
    vec3 a = stepA.xyz - receiver * stepA.w;
    vec3 b = stepB.xyz - receiver * stepB.w;
    float area = a.x * b.y - a.y * b.x;
    vec2 slope = vec2(a.z * b.y - b.z * a.y, b.z * a.x - a.z * b.x) / (abs(area) > 1e-20 ? area : 1e-20);
    // The slope is limited to that of a surface that the light meets at less than a degree.
    float texel = map.depth.x * perW;
    slope = clamp(slope / vec2(textureSize(lightMaps, 0).xy), -256.0 * texel, 256.0 * texel);
    const float roundedDepth = 1e-6;
    float rounding = map.depth.w * map.depth.y * perW * perW + roundedDepth;
    float slack = slackShare * (abs(slope.x) + abs(slope.y) + texel) + rounding;
    float hard = shadowFootprintLight(map, layer, receiver, slope, slack);
#ifdef VCT_SOFT_LIGHTS
    float nearest = receiver.z * projected.w / map.depth.y;
    if (punctual.light[i].cone.z == 0.0) return hard;
    return softVisibility(i, position, normal, towards, hard, 4.0 * map.depth.x / map.depth.y * projected.w,
                          nearest);
#else
    return hard;
#endif
}

// Irradiance of a surface by all punctual lights, relative to the sun's E.
vec3 punctualIrradiance(vec3 position, vec3 normal, float slackShare) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < punctual.count.x; ++i) {
        LightAt light = lightAt(i, position);
        float cosine = dot(normal, light.towards);
        if (cosine <= 0.0 || light.irradiance == vec3(0.0)) continue;
        sum +=
            light.irradiance * (cosine * punctualVisibility(i, position, normal, light.towards, slackShare));
    }
    return sum;
}
