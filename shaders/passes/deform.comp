// Deforms the vertices of a mesh in the present pose: morph targets first, then joints (glTF 2.0, sections
// 3.7.2.2 and 3.7.3.3). The result is in volume space, in the buffer from which all passes read vertices.
// jni/scene/deformation.cpp has the same formulas for the CPU.
#include "shared/layout.h"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_DEFORM) uniform uint ranges[VCT_DEFORM_RANGES];
layout(std430, binding = VCT_SSBO_DEFORM_SOURCES) readonly buffer SourceBlock {
    DeformSource sources[];
};
layout(std430, binding = VCT_SSBO_DEFORM_DISPLACEMENTS) readonly buffer DisplacementBlock {
    float displacements[];  // by target, then by vertex: position, normal
};
layout(std430, binding = VCT_SSBO_DEFORM_STATE) readonly buffer StateBlock {
    vec4 state[];  // three rows of each joint's matrix from mesh to volume; then x: weight of each target
};
layout(std430, binding = VCT_SSBO_DEFORM_VERTICES) writeonly buffer VertexBlock {
    float vertices[];  // position and normal come first
};

void displace(uint vertex, inout vec3 position, inout vec3 normal) {
    for (uint target = 0u; target < ranges[VCT_DEFORM_TARGETS]; ++target) {
        float weight = state[ranges[VCT_DEFORM_FIRST_WEIGHT] + target].x;
        if (weight == 0.0) continue;
        uint at = ranges[VCT_DEFORM_FIRST_DISPLACEMENT] + 6u * (target * ranges[VCT_DEFORM_COUNT] + vertex);
        position += weight * vec3(displacements[at], displacements[at + 1u], displacements[at + 2u]);
        normal += weight * vec3(displacements[at + 3u], displacements[at + 4u], displacements[at + 5u]);
    }
}

vec4 rowOf(DeformSource source, uint row) {
    uint first = ranges[VCT_DEFORM_FIRST_STATE] + row;
    return source.weights.x * state[first + 3u * (source.joints01 & 0xFFFFu)] +
           source.weights.y * state[first + 3u * (source.joints01 >> 16u)] +
           source.weights.z * state[first + 3u * (source.joints23 & 0xFFFFu)] +
           source.weights.w * state[first + 3u * (source.joints23 >> 16u)];
}

// Transforms a normal by the cofactors of the matrix with these rows. They give the direction of the inverse
// transpose, and are finite for a scale of zero.
vec3 turned(vec4 x, vec4 y, vec4 z, vec3 normal) {
    mat3 m = transpose(mat3(x.xyz, y.xyz, z.xyz));
    vec3 result = normal.x * cross(m[1], m[2]) + normal.y * cross(m[2], m[0]) + normal.z * cross(m[0], m[1]);
    if (dot(m[0], cross(m[1], m[2])) < 0.0) result = -result;
    vec3 size = abs(result);
    float largest = max(size.x, max(size.y, size.z));
    return largest > 0.0 ? normalize(result / largest) : normal;
}

void main() {
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint vertex = gl_GlobalInvocationID.x; vertex < ranges[VCT_DEFORM_COUNT]; vertex += stride) {
        DeformSource source = sources[ranges[VCT_DEFORM_FIRST_SOURCE] + vertex];
        vec3 position = source.position, normal = source.normal;
        displace(vertex, position, normal);
        vec4 x = rowOf(source, 0u), y = rowOf(source, 1u), z = rowOf(source, 2u);
        vec4 p = vec4(position, 1.0);
        vec3 positionVolume = vec3(dot(x, p), dot(y, p), dot(z, p));
        vec3 normalVolume = turned(x, y, z, normal);
        uint at = ranges[VCT_DEFORM_FIRST_FLOAT] + vertex * ranges[VCT_DEFORM_VERTEX_FLOATS];
        for (int i = 0; i < 3; ++i) {
            vertices[at + uint(i)] = positionVolume[i];
            vertices[at + 3u + uint(i)] = normalVolume[i];
        }
    }
}
