// Everything that the fragment shader needs, in volume space.
#include "shared/draw.glsl"

layout(location = VCT_ATTRIBUTE_POSITION) in vec3 position;
layout(location = VCT_ATTRIBUTE_NORMAL) in vec3 normal;
out vec3 vertexPosition;
out vec3 vertexNormal;
#ifdef VCT_BASE_COLOR_TEXTURE
layout(location = VCT_ATTRIBUTE_UV) in vec2 uv;
out vec2 vertexUv;
#endif
#ifdef VCT_EMISSIVE_TEXTURE
layout(location = VCT_ATTRIBUTE_EMISSIVE_UV) in vec2 emissiveUv;
out vec2 vertexEmissiveUv;
#endif

void main() {
    vertexPosition = (draw.volumeFromObject * vec4(position, 1.0)).xyz;
    vertexNormal = mat3(draw.normalFromObject) * normal;
#ifdef VCT_BASE_COLOR_TEXTURE
    vertexUv = uv;
#endif
#ifdef VCT_EMISSIVE_TEXTURE
    vertexEmissiveUv = emissiveUv;
#endif
}
