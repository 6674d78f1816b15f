// Resets the lists before a new pose is voxelized, and makes the other one of the two dynamic lists the
// current one. The lists then hold the static geometry, or no voxels if that is listed as well. Static faces
// keep their ids in any case.
#include "shared/commands.glsl"

layout(local_size_x = VCT_LISTS) in;
layout(location = VCT_UNIFORM_STATIC) uniform uint withStatic;

uint groupsOf(uint count) {
    return min((count + uint(VCT_LIST_GROUP) - 1u) / uint(VCT_LIST_GROUP), VCT_MAX_GROUPS);
}

void main() {
    uint list = gl_LocalInvocationIndex, nextDynamic = dynamicList ^ 1u;
    barrier();
    if (list == 0u) {
        dynamicList = nextDynamic;
        if (withStatic != 0u) {
            unplacedFaces = unusedIds = takenIds = takenSums = 0u;
            freePages -= min(takenPages, freePages);
            takenPages = 0u;
        }
    }
    if (list == (nextDynamic ^ 1u)) return;
    if (withStatic != 0u) {
        commands[list].staticVoxels = 0u;
        if (list != 0u) commands[list].staticFaces = 0u;
    }
    commands[list].voxelCount = commands[list].staticVoxels;
    commands[list].groupsX = groupsOf(commands[list].staticVoxels);
    commands[list].faceCount = commands[list].staticFaces;
    // Passes over all faces run without a static face too, because they also remove the pose before the last.
    commands[list].faceGroupsX = max(groupsOf(commands[list].staticFaces), 1u);
}
