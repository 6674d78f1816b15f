// The active-voxel list and its indirect commands. The counters are shared by all invocations: a voxel costs one
// atomic, and every 64th one more for the size of the dispatch.
#include "shared/layout.h"

layout(std430, binding = VCT_SSBO_COMMANDS) buffer CommandBlock {
    LevelCommands commands[VCT_LISTS];
    uint dynamicList;
    uint largestRadiance, largestIrradiance;
};
layout(std430, binding = VCT_SSBO_ACTIVE_VOXELS) buffer ActiveVoxelBlock {
    uint activeVoxels[];
};

// Appends a voxel that was empty until now to its level's list; past the capacity it is only counted. Returns its
// place in the list, which may be past the capacity.
uint appendVoxel(uint level, uvec3 voxel) {
    uint index = atomicAdd(commands[level].voxelCount, 1u);
    if (index >= commands[level].capacity) return index;
    activeVoxels[commands[level].firstEntry + index] = packEntry(voxel);
    if (index % uint(VCT_LIST_GROUP) == 0u && index / uint(VCT_LIST_GROUP) < VCT_MAX_GROUPS)
        atomicAdd(commands[level].groupsX, 1u);
    return index;
}

bool overflowed(uint level) {
    return commands[level].voxelCount > commands[level].capacity;
}

// Entries of a level that can be visited.
uint activeVoxelCount(uint level) {
    return min(commands[level].voxelCount, commands[level].capacity);
}

uvec3 activeVoxel(uint level, uint i) {
    return unpackEntry(activeVoxels[commands[level].firstEntry + i]);
}

// What is to be emptied of a level of side^3 voxels: the i-th of so many. All of them where the list overflowed: what
// found no room in it is not empty either.
uint voxelsToClear(uint level, uint side) {
    return overflowed(level) ? side * side * side : activeVoxelCount(level);
}
uvec3 voxelToClear(uint level, uint side, uint i) {
    return overflowed(level) ? uvec3(i % side, i / side % side, i / (side * side)) : activeVoxel(level, i);
}
