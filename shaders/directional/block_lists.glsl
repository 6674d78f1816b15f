// Marks the occupied voxels of blocks, and lists the faces of blocks.
#include "directional/face_lists.glsl"

// Marks the faces of a voxel in its block.
void markInBlock(ivec3 voxel, uint faces, bool isDynamic) {
    uint bit = bitInBlock(voxel);
    for (uint left = faces; left != 0u; left &= left - 1u) {
        uint words = blockWords(voxel >> VCT_BRICK_LEVEL, findLSB(left), isDynamic);
        atomicOr(faceData[words + (bit >> 5u)], 1u << (bit & 31u));
    }
}

// The word with the bits of a block's faces, and their position in it.
uint maskAt(ivec3 block, out uint shift) {
    uint side = uint(frame.gridSide) >> uint(VCT_BRICK_LEVEL);
    uint place = uint(block.x) + side * (uint(block.y) + side * uint(block.z));
    shift = 8u * (place & 3u);
    return commands[VCT_BRICK_LEVEL].firstMask + place / 4u;
}
void listOfBlock(ivec3 block, uint faces) {
    uint i = faces == 0u ? 0u : reserveFaces(uint(VCT_BRICK_LEVEL), uint(bitCount(faces)));
    for (uint left = faces; left != 0u; left &= left - 1u) {
        storeListed(uint(VCT_BRICK_LEVEL), i++, block, findLSB(left), 0u);
    }
}
