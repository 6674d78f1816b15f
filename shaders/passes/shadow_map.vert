// Vertices of the sun's shadow map (thesis 4.2).
#include "shared/draw.glsl"
#include "shared/frame.glsl"
#include "shared/texture_coordinates.glsl"

layout(location = VCT_ATTRIBUTE_POSITION) in vec3 position;

void main() {
    vec4 shadow = frame.shadowFromVolume * (draw.volumeFromObject * vec4(position, 1.0));
    gl_Position = vec4(shadow.xyz * 2.0 - 1.0, 1.0);
    passTextureCoordinates();
}
