// The face lists. Most voxels have one or two of six faces, so passes iterate over faces and not over voxels.
//
// At the base level, static geometry and dynamic objects have separate lists. The position in these lists
// gives a face its id, which locates its sums and its irradiance. Static faces have the first ids and keep
// them. Two ranges of ids for dynamic faces follow. They alternate from pose to pose, so that a new pose can
// read the last one. With cascades, static faces have two ranges that alternate as well, because cascades
// move. The list of VCT_BRICK_LEVEL holds the faces of blocks: the static ones, then those that only dynamic
// objects cover.
#include "directional/face_data.glsl"
#include "shared/commands.glsl"
#include "shared/counters.glsl"

struct ListedFace {
    ivec3 voxel;
    int face;       // 0..5: +x, -x, +y, -y, +z, -z
    bool isMerged;  // a dynamic face whose sums are added to a static face's
};

ListedFace unpackListed(uint entry) {
    return ListedFace(ivec3(unpackFaceVoxel(entry)), int(unpackFace(entry)), (entry & VCT_MERGED_FACE) != 0u);
}

uint faceCount(uint list) {
    return min(commands[list].faceCount, commands[list].faceCapacity);
}
ListedFace listedFace(uint list, uint i) {
    return unpackListed(faceData[commands[list].firstFace + i]);
}

// The list of the static faces, and the id of its first face.
#if VCT_CASCADES > 1
uint listOfStatic() {
    return staticList;
}
uint firstStaticId() {
    return commands[staticList].firstId;
}
#else
uint listOfStatic() {
    return 0u;
}
uint firstStaticId() {
    return 0u;
}
#endif

// The number of faces of the base level, static and dynamic, and the id of each.
uint baseFaceCount() {
    return faceCount(listOfStatic()) + faceCount(dynamicList);
}
uint baseFaceId(uint i) {
    uint staticCount = faceCount(listOfStatic());
    return i < staticCount ? firstStaticId() + i : commands[dynamicList].firstId + i - staticCount;
}
ListedFace baseFace(uint id) {
    return listedFace(0u, id);
}

// Reserves `count` entries at the end of a list, at most VCT_LIST_GROUP, and returns the position of the
// first. The dispatch over the base level covers static and dynamic faces.
uint reserveFaces(uint list, uint count) {
    uint first = atomicAdd(commands[list].faceCount, count);
    uint group = (first + uint(VCT_LIST_GROUP) - 1u) / uint(VCT_LIST_GROUP);  // the next new work group
    uint dispatched = list < uint(VCT_LIST_DYNAMIC) ? list : 0u;
    if (group * uint(VCT_LIST_GROUP) < first + count && group < VCT_MAX_GROUPS / 2u)
        atomicAdd(commands[dispatched].faceGroupsX, 1u);
    return first;
}
void storeListed(uint list, uint i, ivec3 voxel, int face, uint flags) {
    if (i < commands[list].faceCapacity)
        faceData[commands[list].firstFace + i] = packFace(uvec3(voxel), uint(face)) | flags;
}
