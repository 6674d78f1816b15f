// The active-voxel lists and their indirect commands. Appending a voxel takes one atomic operation, and every
// 64th voxel takes another one for the size of the dispatch.
#include "shared/counts.glsl"

layout(std430, binding = VCT_SSBO_ACTIVE_VOXELS) buffer ActiveVoxelBlock {
    uint activeVoxels[];
};

// Appends a voxel to a level's list; the caller makes sure that it is not listed yet. Beyond the capacity it
// is only counted. Returns its position in the list.
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

// The number of entries in a level's list.
uint activeVoxelCount(uint level) {
    return min(commands[level].voxelCount, commands[level].capacity);
}

uvec3 activeVoxel(uint level, uint i) {
    return unpackEntry(activeVoxels[commands[level].firstEntry + i]);
}

// The number of voxels to clear in a level of side^3 voxels, and the i-th one. If the list overflowed, these
// are all voxels, because occupied voxels are missing in the list.
uint voxelsToClear(uint level, uint side) {
    return overflowed(level) ? side * side * side : activeVoxelCount(level);
}
uvec3 voxelToClear(uint level, uint side, uint i) {
    return overflowed(level) ? uvec3(i % side, i / side % side, i / (side * side)) : activeVoxel(level, i);
}
