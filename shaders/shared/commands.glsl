// The active-voxel list and its indirect commands. The counters are shared by all invocations: a voxel costs one
// atomic, and every 64th one more for the size of the dispatch.
#include "shared/layout.h"

layout(std430, binding = VCT_SSBO_COMMANDS) buffer CommandBlock {
    LevelCommands commands[VCT_MAX_LEVELS];
};
layout(std430, binding = VCT_SSBO_ACTIVE_VOXELS) buffer ActiveVoxelBlock {
    uint activeVoxels[];
};

// Appends a voxel that was empty until now to its level's list; past the capacity it is only counted. Returns its
// place in the list, which may be past the capacity.
uint appendVoxel(uint level, uvec3 voxel) {
    uint index = atomicAdd(commands[level].instanceCount, 1u);
    if (index >= commands[level].capacity) return index;
    activeVoxels[commands[level].firstEntry + index] = packEntry(voxel);
    if (index % uint(VCT_LIST_GROUP) == 0u && index / uint(VCT_LIST_GROUP) < VCT_MAX_GROUPS)
        atomicAdd(commands[level].groupsX, 1u);
    return index;
}

bool overflowed(uint level) {
    return commands[level].instanceCount > commands[level].capacity;
}

// Entries of a level that can be visited.
uint activeVoxelCount(uint level) {
    return min(commands[level].instanceCount, commands[level].capacity);
}

// Where they are in the list that is bound: the first, and behind the last.
#ifdef VCT_PART
layout(location = VCT_UNIFORM_FIRST) uniform uint partFirst;
layout(location = VCT_UNIFORM_END) uniform uint partEnd;  // 0: to the end of what is active
bool partIsMoving() {
    return partEnd == 0u;
}
uint firstVisited(uint level) {
    return partFirst;
}
uint endVisited(uint level) {
    return partIsMoving() ? commands[level].firstEntry + activeVoxelCount(level) : partEnd;
}
#else
uint firstVisited(uint level) {
    return commands[level].firstEntry;
}
uint endVisited(uint level) {
    return commands[level].firstEntry + activeVoxelCount(level);
}
#endif

// What is to be emptied of a level of side^3 voxels: the i-th of so many. All of them where the list overflowed: what
// found no room in it is not empty either.
bool emptiesAll(uint level) {
#ifdef VCT_PART
    if (!partIsMoving()) return false;
#endif
    return overflowed(level);
}
uint voxelsToEmpty(uint level, uint side) {
    return emptiesAll(level) ? side * side * side : endVisited(level) - firstVisited(level);
}
uvec3 voxelToEmpty(uint level, uint side, uint i) {
    return emptiesAll(level) ? uvec3(i % side, i / side % side, i / (side * side))
                             : unpackEntry(activeVoxels[firstVisited(level) + i]);
}
