// What a pass visits where something moves: first some of what the static geometry occupies, from a list of its own,
// sorted by block; then what moves, from the level's list on.
#include "directional/face_list.glsl"

layout(std430, binding = VCT_SSBO_STATIC_ENTRIES) readonly buffer StaticEntryBlock {
    uint staticEntries[];
};
layout(location = VCT_UNIFORM_FIRST) uniform uint firstStatic;
layout(location = VCT_UNIFORM_END) uniform uint endStatic;
layout(location = VCT_UNIFORM_MOVING) uniform uint firstMoving;  // in the level's list

uint staticVisited() {
    return endStatic - firstStatic;
}
bool isMoving(uint i) {
    return i >= staticVisited();
}

// `count`: of the entries in the level's list.
uint visitedOf(uint count) {
    return staticVisited() + (count > firstMoving ? count - firstMoving : 0u);
}
uvec3 visitedVoxel(uint level, uint i) {
    return isMoving(i) ? activeVoxel(level, firstMoving + i - staticVisited())
                       : unpackEntry(staticEntries[firstStatic + i]);
}
ListedFace visitedFace(uint level, uint i) {
    return isMoving(i) ? listedFace(level, firstMoving + i - staticVisited())
                       : unpackListed(staticEntries[firstStatic + i]);
}
