// Transforms vertices to volume space for voxelization. With VCT_SORTED_AXES the triangles of a draw call
// share an axis, so this shader also projects them; otherwise a geometry shader does.
#ifndef VCT_SORTED_AXES
#define fragmentPosition vertexPosition
#define fragmentNormal vertexNormal
#define fragmentUv vertexUv
#define fragmentEmissiveUv vertexEmissiveUv
#define fragmentColor vertexColor
#endif
#include "directional/cascades.glsl"
#include "shared/draw.glsl"
#include "shared/dominant_axis.h"
#include "shared/texture_coordinates.glsl"

layout(location = VCT_ATTRIBUTE_POSITION) in vec3 position;
layout(location = VCT_ATTRIBUTE_NORMAL) in vec3 normal;
out vec3 fragmentPosition;
centroid out vec3 fragmentNormal;

#ifdef VCT_SORTED_AXES
#include "shared/projection.glsl"
layout(location = VCT_UNIFORM_AXIS) uniform uint axis;
void project(vec3 positionVolume) {
    gl_Position = projectedAlong(int(axis), positionVolume);
}
#else
void project(vec3 positionVolume) {}
#endif

#if VCT_CASCADES > 1
layout(location = VCT_UNIFORM_CASCADE) uniform uint cascade;  // cascade that triangles are voxelized into
// The position in the cascade, which is the cube [0, 1]^3. The cascade is voxelized like a volume.
vec3 inCascade(vec3 positionVolume) {
    vec4 cube = frame.cascade[cascade];
    return (positionVolume - cube.xyz) * (cube.w / float(frame.gridSide));
}
#else
vec3 inCascade(vec3 positionVolume) {
    return positionVolume;
}
#endif

void main() {
    vec3 positionVolume = inCascade(positionInVolume(draw.volumeFromObject, position));
    fragmentPosition = positionVolume;
    fragmentNormal = mat3(draw.normalFromObject) * normal;
    passTextureCoordinates();
    project(positionVolume);
}
