// Writes the triangles of a deformed mesh three times, once per axis. In the range of an axis, triangles with
// another dominant axis shrink to a point, which the rasterizer drops. Rigid meshes are sorted on the CPU
// instead (jni/engine/axis_sort.h).
#include "shared/dominant_axis.h"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_DEFORM) uniform uint ranges[VCT_DEFORM_RANGES];
layout(std430, binding = VCT_SSBO_DEFORM_VERTICES) readonly buffer VertexBlock {
    float vertices[];  // volume space; position comes first
};
layout(std430, binding = VCT_SSBO_SORT_CORNERS) readonly buffer CornerBlock {
    uint corners[];  // three vertices per triangle
};
layout(std430, binding = VCT_SSBO_SORT_SORTED) writeonly buffer SortedBlock {
    uint sorted[];  // three vertices per triangle: all along x, then all along y, then all along z
};

vec3 positionOf(uint corner) {
    uint vertex = corner - ranges[VCT_SORT_FIRST_VERTEX];
    uint at = ranges[VCT_DEFORM_FIRST_FLOAT] + vertex * ranges[VCT_DEFORM_VERTEX_FLOATS];
    return vec3(vertices[at], vertices[at + 1u], vertices[at + 2u]);
}

void main() {
    uint count = ranges[VCT_DEFORM_COUNT];
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint triangle = gl_GlobalInvocationID.x; triangle < count; triangle += stride) {
        uint first = ranges[VCT_SORT_FIRST_CORNER] + 3u * triangle;
        uvec3 corner = uvec3(corners[first], corners[first + 1u], corners[first + 2u]);
        int axis = dominantAxis(positionOf(corner.x), positionOf(corner.y), positionOf(corner.z));
        for (int i = 0; i < 3; ++i) {
            uvec3 here = i == axis ? corner : corner.xxx;
            uint at = ranges[VCT_SORT_FIRST_SORTED] + 3u * (uint(i) * count + triangle);
            sorted[at] = here.x;
            sorted[at + 1u] = here.y;
            sorted[at + 2u] = here.z;
        }
    }
}
