// Copies vertices from buffers of the embedding program to those that passes/deform.comp reads.
#include "shared/layout.h"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_DEFORM) uniform uint ranges[VCT_DEFORM_RANGES];
layout(location = VCT_UNIFORM_COPY_CENTRE) uniform vec4 centre;
layout(std430, binding = VCT_SSBO_COPY_POSITIONS) readonly buffer PositionBlock {
    float positions[];
};
layout(std430, binding = VCT_SSBO_COPY_NORMALS) readonly buffer NormalBlock {
    float normals[];
};
layout(std430, binding = VCT_SSBO_DEFORM_SOURCES) buffer SourceBlock {
    DeformSource sources[];
};

void main() {
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint vertex = gl_GlobalInvocationID.x; vertex < ranges[VCT_DEFORM_COUNT]; vertex += stride) {
        uint p = ranges[VCT_COPY_FIRST_POSITION] + vertex * ranges[VCT_COPY_POSITION_STRIDE];
        uint n = ranges[VCT_COPY_FIRST_NORMAL] + vertex * ranges[VCT_COPY_NORMAL_STRIDE];
        uint at = ranges[VCT_DEFORM_FIRST_SOURCE] + vertex;
        sources[at].position = vec3(positions[p], positions[p + 1u], positions[p + 2u]) - centre.xyz;
        sources[at].normal = vec3(normals[n], normals[n + 1u], normals[n + 2u]);
    }
}
