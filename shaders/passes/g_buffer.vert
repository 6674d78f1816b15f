// Vertices of the G-buffer pass (thesis 4.3).
#include "shared/draw.glsl"
#include "shared/frame.glsl"
#include "shared/texture_coordinates.glsl"

layout(location = VCT_ATTRIBUTE_POSITION) in vec3 position;
layout(location = VCT_ATTRIBUTE_NORMAL) in vec3 normal;
out vec3 fragmentNormal;
#ifdef VCT_NORMAL_MAP
out vec3 fragmentFromEye;  // volume space, relative to the eye for precision close to it
void passPosition(vec3 positionVolume) {
    fragmentFromEye = positionVolume - frame.eye.xyz;
}
#else
void passPosition(vec3 positionVolume) {}
#endif

void main() {
    vec4 positionVolume = draw.volumeFromObject * vec4(position, 1.0);
    gl_Position = frame.clipFromVolume * positionVolume;
    fragmentNormal = mat3(draw.normalFromObject) * normal;
    passPosition(positionVolume.xyz);
    passTextureCoordinates();
}
