// Vertices of a punctual light's shadow map. It stores depth in 16 bits. Those of a projection would be too
// coarse far away from the light, so the maps of point and spot lights store the distance w along the map's
// axis, in units of that to the far plane.
#include "shared/draw.glsl"
#include "shared/layout.h"
#include "shared/texture_coordinates.glsl"

layout(std140, binding = VCT_UBO_PUNCTUAL_LIGHTS) uniform PunctualLightsBlock {
    PunctualLightBlock punctual;
};
layout(location = VCT_UNIFORM_LIGHT_MAP) uniform uint map;
layout(location = VCT_ATTRIBUTE_POSITION) in vec3 position;
out float storedDepth;

void main() {
    vec4 inMap = punctual.map[map].mapFromVolume * (draw.volumeFromObject * vec4(position, 1.0));
    gl_Position = vec4(2.0 * inMap.xyz - inMap.w, inMap.w);
    vec4 depth = punctual.map[map].depth;
    storedDepth = depth.z == 0.0 ? inMap.z : inMap.w * (depth.z / depth.y);
    passTextureCoordinates();
}
