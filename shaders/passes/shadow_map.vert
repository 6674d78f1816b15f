// Vertices of the sun's shadow map (thesis 4.2).
#include "directional/cascades.glsl"
#include "shared/draw.glsl"
#include "shared/texture_coordinates.glsl"

layout(location = VCT_ATTRIBUTE_POSITION) in vec3 position;

#if VCT_CASCADES > 1
layout(location = VCT_UNIFORM_SHADOW_TILE) uniform uint tileIndex;
// The position in the tile that is drawn.
vec3 inShadowMap(vec4 positionVolume) {
    int tile = int(tileIndex);
    vec3 map = (frame.shadowTileFromVolume[tile] * positionVolume).xyz;
    return vec3(map.xy * 2.0 - vec2(tile & 1, tile >> 1), map.z);
}
#else
vec3 inShadowMap(vec4 positionVolume) {
    return (frame.shadowFromVolume * positionVolume).xyz;
}
#endif

void main() {
    vec3 shadow = inShadowMap(draw.volumeFromObject * vec4(position, 1.0));
    gl_Position = vec4(shadow * 2.0 - 1.0, 1.0);
    passTextureCoordinates();
}
