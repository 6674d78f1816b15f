// Marks the occupied voxels of blocks, and lists the faces of blocks.
#include "directional/face_lists.glsl"

// The bit of a voxel, and the position of the first of the six words, two apart, that have it for a face.
struct Mark {
    uint at, bit;
};
Mark markOf(ivec3 voxel, bool isDynamic) {
    uint place = bitInBlock(voxel);
    return Mark(markWords(voxel >> VCT_BRICK_LEVEL, 0, isDynamic) + (place >> 5u), 1u << (place & 31u));
}
// Marks the faces of a voxel in its block. Returns true unless all of them are marked already.
bool markInBlock(ivec3 voxel, uint faces, bool isDynamic) {
    Mark mark = markOf(voxel, isDynamic);
    bool isNew = false;
    for (uint left = faces; left != 0u; left &= left - 1u) {
        uint at = mark.at + 2u * uint(findLSB(left));
        if ((faceData[at] & mark.bit) != 0u) continue;
        atomicOr(faceData[at], mark.bit);
        isNew = true;
    }
    return isNew;
}
// The marked faces of a voxel.
uint markedFaces(ivec3 voxel, bool isDynamic) {
    Mark mark = markOf(voxel, isDynamic);
    uint faces = 0u;
    for (uint face = 0u; face < 6u; ++face)
        if ((faceData[mark.at + 2u * face] & mark.bit) != 0u) faces |= 1u << face;
    return faces;
}
void unmarkInBlock(ivec3 voxel, bool isDynamic) {
    Mark mark = markOf(voxel, isDynamic);
    for (uint face = 0u; face < 6u; ++face)
        atomicAnd(faceData[mark.at + 2u * face], ~mark.bit);
}

// The word with the bits of a block's faces, and their position in it.
uint maskAt(ivec3 block, out uint shift) {
    uint place = numberOfBlock(block);
    shift = 8u * (place & 3u);
    return commands[VCT_BRICK_LEVEL].firstMask + place / 4u;
}
// The position of a free page; 0 if there is none. No pass takes pages and gives others back.
uint takePage() {
    uint i = atomicAdd(takenPages, 1u);
    return i < freePages ? faceData[firstFreePage + freePages - 1u - i] : 0u;
}
// Appends a block to those whose marked faces list_faces.comp lists, unless it is one of them. The invocation
// that does so also takes the block's page, which has no cells before list_faces.comp.
void markBlock(ivec3 block, bool isDynamic) {
    const uint level = uint(VCT_BRICK_LEVEL);
    uint shift, at = maskAt(block, shift), mark = VCT_MARKED_BLOCK << shift;
    if ((faceData[at] & mark) != 0u || (atomicOr(faceData[at], mark) & mark) != 0u) return;
    uint i = atomicAdd(commands[level].voxelCount, 1u);
    activeVoxels[commands[level].firstEntry + i] = packEntry(uvec3(block));
    const uint perGroup = uint(VCT_LIST_GROUP) / uint(VCT_BRICK_SIDE);  // an invocation per layer
    if (i % perGroup == 0u && i / perGroup < VCT_MAX_GROUPS) atomicAdd(commands[level].groupsX, 1u);
    uint page = pageAt(numberOfBlock(block));
    if (cascades > 1 && !isDynamic && faceData[page] == 0u) faceData[page] = takePage();
}
void listOfBlock(ivec3 block, uint faces) {
    uint i = faces == 0u ? 0u : reserveFaces(uint(VCT_BRICK_LEVEL), uint(bitCount(faces)));
    for (uint left = faces; left != 0u; left &= left - 1u) {
        storeListed(uint(VCT_BRICK_LEVEL), i++, block, findLSB(left), 0u);
    }
}
