// Marks the listed voxels and faces of all levels as static. The blocks with marked faces (block_lists.glsl)
// have been listed, and others follow.
#include "shared/commands.glsl"

layout(local_size_x = VCT_LIST_DYNAMIC) in;

void main() {
    uint level = gl_LocalInvocationIndex;
    if (level == uint(VCT_BRICK_LEVEL)) commands[level].voxelCount = commands[level].groupsX = 0u;
    commands[level].staticVoxels = commands[level].voxelCount;
    commands[level].staticFaces = commands[level].faceCount;
}
