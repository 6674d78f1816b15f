// Projects each triangle along the dominant axis of its face normal (thesis algorithm 7), so that the
// rasterizer touches every voxel column that the triangle crosses.
#include "shared/blocks.glsl"

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

void main() {
    vec3 size = abs(cross(vertexPosition[1] - vertexPosition[0], vertexPosition[2] - vertexPosition[0]));
    // A degenerate triangle covers nothing; normalising its normal would give NaN.
    if (!(size.x + size.y + size.z > 0.0)) return;
    // Faces at exactly 45 degrees are common; the preference keeps rounding from deciding, so every driver
    // takes the same axis.
    const float preference = 1.0001;
    bool alongX = size.x * preference >= max(size.y, size.z);
    bool alongY = !alongX && size.y * preference >= size.z;
    for (int i = 0; i < 3; ++i) {
        vec3 p = vertexPosition[i];
        vec2 projected = alongX ? p.yz : alongY ? p.zx : p.xy;
        fragmentPosition = p;
        fragmentNormal = vertexNormal[i];
#ifdef VCT_BASE_COLOR_TEXTURE
        fragmentUv = vertexUv[i];
#endif
#ifdef VCT_EMISSIVE_TEXTURE
        fragmentEmissiveUv = vertexEmissiveUv[i];
#endif
        gl_Position = vec4(projected * 2.0 - 1.0, 0.0, 1.0);
        EmitVertex();
    }
    EndPrimitive();
}
