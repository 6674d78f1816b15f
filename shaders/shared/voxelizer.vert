// Everything that the fragment shader needs, in volume space; projected too where the triangles of a draw call share
// an axis (VCT_SORTED_AXES), and no geometry shader has to find it out.
#include "shared/draw.glsl"
#include "shared/dominant_axis.h"

#ifdef VCT_SORTED_AXES
#include "shared/projection.glsl"
layout(location = VCT_UNIFORM_AXIS) uniform uint axis;
#define vertexPosition fragmentPosition
#define vertexNormal fragmentNormal
#define vertexUv fragmentUv
#define vertexEmissiveUv fragmentEmissiveUv
#endif

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
    vertexPosition = positionInVolume(draw.volumeFromObject, position);
    vertexNormal = mat3(draw.normalFromObject) * normal;
#ifdef VCT_BASE_COLOR_TEXTURE
    vertexUv = uv;
#endif
#ifdef VCT_EMISSIVE_TEXTURE
    vertexEmissiveUv = emissiveUv;
#endif
#ifdef VCT_SORTED_AXES
    gl_Position = projectedAlong(int(axis), vertexPosition);
#endif
}
