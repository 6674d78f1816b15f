// Projects each triangle along the dominant axis of its face normal (thesis algorithm 7), so that the
// rasterizer touches every voxel column that the triangle crosses.
#include "shared/projection.glsl"

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in vec3 vertexPosition[];
in vec3 vertexNormal[];
out vec3 fragmentPosition;
out vec3 fragmentNormal;
#ifdef VCT_BASE_COLOR_TEXTURE
in vec2 vertexUv[];
out vec2 fragmentUv;
#endif
#ifdef VCT_EMISSIVE_TEXTURE
in vec2 vertexEmissiveUv[];
out vec2 fragmentEmissiveUv;
#endif
#ifdef VCT_VERTEX_COLORS
in vec4 vertexColor[];
out vec4 fragmentColor;
#endif

void main() {
    int axis = dominantAxis(vertexPosition[0], vertexPosition[1], vertexPosition[2]);
    if (axis == VCT_AXIS_NONE) return;
    for (int i = 0; i < 3; ++i) {
        fragmentPosition = vertexPosition[i];
        fragmentNormal = vertexNormal[i];
#ifdef VCT_BASE_COLOR_TEXTURE
        fragmentUv = vertexUv[i];
#endif
#ifdef VCT_EMISSIVE_TEXTURE
        fragmentEmissiveUv = vertexEmissiveUv[i];
#endif
#ifdef VCT_VERTEX_COLORS
        fragmentColor = vertexColor[i];
#endif
        gl_Position = projectedAlong(axis, vertexPosition[i]);
        EmitVertex();
    }
    EndPrimitive();
}
