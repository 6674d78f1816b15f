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

// Those that a pass visits: how many, and the i-th of them. With VCT_PART first some of what the static geometry
// occupies, from a list of its own, then what moves, from the level's list on; or one of the two.
#ifdef VCT_PART
layout(std430, binding = VCT_SSBO_STATIC_ENTRIES) readonly buffer StaticEntryBlock {
    uint staticEntries[];
};
layout(location = VCT_UNIFORM_FIRST) uniform uint firstStatic;
layout(location = VCT_UNIFORM_END) uniform uint endStatic;
layout(location = VCT_UNIFORM_MOVING) uniform uint firstMoving;  // in the level's list, or VCT_NO_ENTRY
uint staticVisited() {
    return endStatic - firstStatic;
}
bool isMoving(uint i) {
    return i >= staticVisited();
}
// `count`: of the entries in the level's list.
uint partVisited(uint count) {
    return staticVisited() + (count > firstMoving ? count - firstMoving : 0u);
}
uint visitedCount(uint level) {
    return partVisited(activeVoxelCount(level));
}
uint visitedEntry(uint level, uint i) {
    return isMoving(i) ? activeVoxels[commands[level].firstEntry + firstMoving + i - staticVisited()]
                       : staticEntries[firstStatic + i];
}
#else
uint visitedCount(uint level) {
    return activeVoxelCount(level);
}
uint visitedEntry(uint level, uint i) {
    return activeVoxels[commands[level].firstEntry + i];
}
#endif

// What is to be emptied of a level of side^3 voxels: the i-th of so many. All of them where the list overflowed: what
// found no room in it is not empty either.
uint voxelsToEmpty(uint level, uint side) {
    return overflowed(level) ? side * side * side : visitedCount(level);
}
uvec3 voxelToEmpty(uint level, uint side, uint i) {
    return overflowed(level) ? uvec3(i % side, i / side % side, i / (side * side))
                             : unpackEntry(visitedEntry(level, i));
}
