// The occupied voxels of each block of 4^3 voxels, as bits, from which directional/fill_blocks.comp makes the
// texture that rays read. For each of the six face directions there are two words: bit x + 4 y + 16 z of the
// 64 is set if the voxel (x, y, z) of the block has such a face. The words of all blocks are at the beginning
// of the faces' buffer: those of the static voxels, then those of the dynamic ones.
#include "directional/cascades.glsl"

// The position of a block's words of a face direction.
uint blockWords(ivec3 block, int face, bool isDynamic) {
    uint side = uint(frame.gridSide) / uint(VCT_BRICK_SIDE);
    uint place = uint(block.x) + side * (uint(block.y) + side * uint(block.z));
    return VCT_BLOCK_WORDS * place + uint(2 * face) + (isDynamic ? 12u : 0u);
}
// The bit of a voxel in its block.
uint bitInBlock(ivec3 voxel) {
    return uint((voxel.x & 3) + 4 * (voxel.y & 3) + 16 * (voxel.z & 3));
}
// The number of words of all blocks.
uint allBlockWords() {
    uint side = uint(frame.gridSide) / uint(VCT_BRICK_SIDE);
    return VCT_BLOCK_WORDS * side * side * side * uint(cascades);
}
