// Vertices of the G-buffer pass (thesis 4.3).
#include "shared/draw.glsl"
#include "shared/frame.glsl"
#include "shared/texture_coordinates.glsl"

layout(location = VCT_ATTRIBUTE_POSITION) in vec3 position;
layout(location = VCT_ATTRIBUTE_NORMAL) in vec3 normal;
out vec3 fragmentNormal;
out vec3 fragmentFromEye;  // volume space, relative to the eye for precision close to it

void main() {
    vec4 positionVolume = draw.volumeFromObject * vec4(position, 1.0);
    gl_Position = frame.clipFromVolume * positionVolume;
    fragmentNormal = mat3(draw.normalFromObject) * normal;
    fragmentFromEye = positionVolume.xyz - frame.eye.xyz;
    passTextureCoordinates();
}
