// The face lists: one list of occupied faces per level. Most voxels have one or two of six faces, so passes
// iterate over faces and not over voxels.
//
// At the base level, static geometry and dynamic objects have separate lists. The position in these lists
// gives a face its id, which locates its sums and its irradiance. Static faces have the first ids and keep
// them. Two ranges of ids for dynamic faces follow. They alternate from pose to pose, so that a new pose can
// read the last one. With cascades, static faces have two ranges that alternate as well, because cascades
// move. Above the base level, a list holds the static faces, then the faces that only dynamic objects cover.
#include "shared/commands.glsl"
#include "shared/counters.glsl"

layout(std430, binding = VCT_SSBO_FACES) buffer FaceBlock {
    uint faceData[];  // sums by id, then the lists; above the base level also a bit per occupied face
};

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

// A voxel's texel in the index: a bit per occupied face, and above them the position of its first face in the
// list, counted from 1. The position is 0 if the voxel did not fit into the active-voxel list.
uint packCell(uint first, uint faces) {
    return (first + 1u) << VCT_FACE_MASK_BITS | faces;
}
bool hasFace(uint cell, int face) {
    return (cell >> uint(face) & 1u) != 0u && cell > VCT_FACE_MASK;
}
// The id of an occupied face. `firstId`: the list's first id.
uint faceId(uint cell, int face, uint firstId) {
    return firstId + (cell >> VCT_FACE_MASK_BITS) - 1u + uint(bitCount(cell & ((1u << uint(face)) - 1u)));
}
// The id of a static face. Returns false if there is none. With cascades, the list may have had no room for
// it.
bool findStaticFace(uint cell, int face, out uint id) {
    id = faceId(cell, face, firstStaticId());
    return hasFace(cell, face) && (VCT_CASCADES == 1 || id < firstStaticId() + faceCount(listOfStatic()));
}
// The id of a face that dynamic objects cover. Returns false if there is none, or the list had no room for
// it.
bool findDynamicFace(uint cell, int face, out uint id) {
    uint first = commands[dynamicList].firstId;
    id = faceId(cell, face, first);
    return hasFace(cell, face) && id < first + faceCount(dynamicList);
}
