// The scene from the camera (thesis 4.3).
#include "directional/blocks.glsl"
#include "shared/draw.glsl"

layout(location = VCT_ATTRIBUTE_POSITION) in vec3 position;
layout(location = VCT_ATTRIBUTE_NORMAL) in vec3 normal;
out vec3 fragmentNormal;
#ifdef VCT_BASE_COLOR_TEXTURE
layout(location = VCT_ATTRIBUTE_UV) in vec2 uv;
out vec2 fragmentUv;
#endif
#ifdef VCT_EMISSIVE_TEXTURE
layout(location = VCT_ATTRIBUTE_EMISSIVE_UV) in vec2 emissiveUv;
out vec2 fragmentEmissiveUv;
#endif

void main() {
    vec4 positionVolume = draw.volumeFromObject * vec4(position, 1.0);
    gl_Position = frame.clipFromVolume * positionVolume;
    fragmentNormal = mat3(draw.normalFromObject) * normal;
#ifdef VCT_BASE_COLOR_TEXTURE
    fragmentUv = uv;
#endif
#ifdef VCT_EMISSIVE_TEXTURE
    fragmentEmissiveUv = emissiveUv;
#endif
}
