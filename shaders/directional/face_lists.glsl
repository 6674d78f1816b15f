// The faces that are not empty, listed per level: most voxels have one or two of six, and a pass over voxels would idle
// at the others.
//
// At the base level the static geometry and the dynamic objects have lists of their own. A face's place in them is its id,
// by which its words and its irradiance are found: ids begin with the static faces, which keep theirs for good. Two ranges
// for dynamic faces follow, which alternate from pose to pose, so that a new pose can look up the one before. Above the
// base level a list holds the static faces first and those that only dynamic objects fill behind them.
#include "shared/commands.glsl"
#include "shared/counters.glsl"

layout(std430, binding = VCT_SSBO_FACES) buffer FaceBlock {
    uint faceData[];  // words of each id; the lists; bits of the faces that are not empty above the base level
};

struct ListedFace {
    ivec3 voxel;
    int face;       // 0..5: +x, -x, +y, -y, +z, -z
    bool isMerged;  // a static face has its light
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

// All faces of the base level: the number of them, and the id of each.
uint baseFaceCount() {
    return faceCount(0u) + faceCount(dynamicList);
}
uint baseFaceId(uint i) {
    uint staticCount = faceCount(0u);
    return i < staticCount ? i : commands[dynamicList].firstId + i - staticCount;
}
ListedFace baseFace(uint id) {
    return listedFace(0u, id);
}

// Makes room for `count` faces at the end of a list, at most VCT_LIST_GROUP, and returns the place of the first. A
// dispatch over the base level's list covers the dynamic faces too.
uint reserveFaces(uint list, uint count) {
    uint first = atomicAdd(commands[list].faceCount, count);
    uint group = (first + uint(VCT_LIST_GROUP) - 1u) / uint(VCT_LIST_GROUP);  // the next to begin
    uint dispatched = list < uint(VCT_LIST_DYNAMIC) ? list : 0u;
    if (group * uint(VCT_LIST_GROUP) < first + count && group < VCT_MAX_GROUPS / 2u)
        atomicAdd(commands[dispatched].faceGroupsX, 1u);
    return first;
}
void storeListed(uint list, uint i, ivec3 voxel, int face, uint flags) {
    if (i < commands[list].faceCapacity) faceData[commands[list].firstFace + i] = packFace(uvec3(voxel), uint(face)) | flags;
}

// The texel of a voxel in the index of the static geometry or of a pose: which faces are not empty, and the place of the first
// of them in the list, from 1 on. It is 0 where the voxel found no room in the list of voxels.
uint packCell(uint first, uint faces) {
    return (first + 1u) << VCT_FACE_MASK_BITS | faces;
}
bool hasFace(uint cell, int face) {
    return (cell >> uint(face) & 1u) != 0u && cell > VCT_FACE_MASK;
}
// The id of a face that there is; `firstId`: of the list.
uint faceId(uint cell, int face, uint firstId) {
    return firstId + (cell >> VCT_FACE_MASK_BITS) - 1u + uint(bitCount(cell & ((1u << uint(face)) - 1u)));
}
