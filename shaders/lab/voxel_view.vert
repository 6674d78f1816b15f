// Draws a cube per listed voxel of a level, as instances. The list is an instanced integer attribute, because
// vertex shaders cannot read storage buffers on Mali.
#include "packed/voxel_sample.glsl"

layout(location = VCT_ATTRIBUTE_VOXEL) in uint entry;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;
flat out vec3 color;
out vec3 corner;

void main() {
    uvec3 voxel = unpackEntry(entry);
    // The three bits of the index are the corner's coordinates.
    corner = vec3(gl_VertexID & 1, gl_VertexID >> 1 & 1, gl_VertexID >> 2 & 1);
    uint word = texelFetch(voxels, ivec3(voxel), int(level)).r;
    vec3 unlit = vec3(0.06, 0.07, 0.09);  // not black, so that voxels in shadow show their shape
    color = voxelLight(word) != 0u ? max(unpackSample(word).rgb, unlit) : unlit;
    vec3 position = (vec3(voxel) + corner) / float(uint(frame.gridSide) >> level);
    gl_Position = frame.clipFromVolume * vec4(position, 1.0);
}
