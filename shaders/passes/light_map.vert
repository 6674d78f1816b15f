// Vertices of a punctual light's shadow map.
#include "shared/draw.glsl"
#include "shared/layout.h"
#include "shared/texture_coordinates.glsl"

layout(std140, binding = VCT_UBO_PUNCTUAL_LIGHTS) uniform PunctualLightsBlock {
    PunctualLightBlock punctual;
};
layout(location = VCT_UNIFORM_LIGHT_MAP) uniform uint map;
layout(location = VCT_ATTRIBUTE_POSITION) in vec3 position;

void main() {
    vec4 inMap = punctual.map[map].mapFromVolume * (draw.volumeFromObject * vec4(position, 1.0));
    gl_Position = vec4(2.0 * inMap.xyz - inMap.w, inMap.w);
    passTextureCoordinates();
}
