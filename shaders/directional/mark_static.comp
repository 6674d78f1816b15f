// Marks the listed voxels and faces of all levels as static, or none of them. Only with cascades; without
// them the static geometry never changes (DirectionalVoxels::markStatic()).
#include "shared/commands.glsl"
#include "shared/counters.glsl"

layout(local_size_x = VCT_LIST_DYNAMIC) in;
layout(location = VCT_UNIFORM_KEEPS) uniform uint keeps;  // 1: all; 0: none

void main() {
    COUNT(VCT_COUNTER_MARK_STATIC);
    // The dispatch over the base level's faces is that of list 0.
    uint level = gl_LocalInvocationIndex, faces = level == 0u ? staticList : level;
    commands[level].staticVoxels = keeps * commands[level].voxelCount;
    commands[level].staticFaces = keeps * commands[faces].faceCount;
}
