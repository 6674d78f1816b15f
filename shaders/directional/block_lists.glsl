// Marks the occupied voxels of blocks, and lists the faces of blocks.
#include "directional/face_lists.glsl"

// Adds a voxel's faces to its block. `isListed`: the faces that the block lists if it has not yet. The first
// voxel that sets the bit of a block's face lists it.
void addToBlock(ivec3 voxel, uint faces, uint isListed, bool isDynamic) {
    const uint bricks = uint(VCT_BRICK_LEVEL);
    ivec3 block = voxel >> VCT_BRICK_LEVEL;
    uint bit = bitInBlock(voxel);
    for (uint left = faces; left != 0u; left &= left - 1u)
        atomicOr(faceData[blockWords(block, findLSB(left), isDynamic) + (bit >> 5u)], 1u << (bit & 31u));
    uint side = uint(frame.gridSide) >> bricks;
    uint place = uint(block.x) + side * (uint(block.y) + side * uint(block.z)), shift = 8u * (place & 3u);
    uint at = commands[bricks].firstMask + place / 4u;
    uint added = isListed & ~(atomicOr(faceData[at], isListed << shift) >> shift);
    uint i = added == 0u ? 0u : reserveFaces(bricks, uint(bitCount(added)));
    for (uint left = added; left != 0u; left &= left - 1u) {
        COUNT(VCT_COUNTER_LIST_FACES_BLOCK_FACE);
        storeListed(bricks, i++, block, findLSB(left), 0u);
    }
}
