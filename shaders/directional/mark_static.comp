// Marks the listed voxels and faces of all levels as static.
#include "shared/commands.glsl"

layout(local_size_x = VCT_LIST_DYNAMIC) in;

void main() {
    uint level = gl_LocalInvocationIndex;
    commands[level].staticVoxels = commands[level].voxelCount;
    commands[level].staticFaces = commands[level].faceCount;
}
