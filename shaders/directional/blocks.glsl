// The occupied voxels of each block of 4^3 voxels, as bits, from which directional/fill_blocks.comp makes the
// texture that rays read. For each of the six face directions there are two words: bit x + 4 y + 16 z of the
// 64 is set if the voxel (x, y, z) of the block has such a face. The words of all blocks are at the beginning
// of the faces' buffer. In one cube a block has the words of the static voxels, then those of the dynamic
// ones.
//
// Few blocks of cascades have static faces. Each of those has a page elsewhere in the buffer: the cell of
// each voxel (directional/index.glsl), the words of the static voxels, and the static walls
// (directional/walls.glsl). The block has the position of its
// page, behind the words of the dynamic voxels. While static geometry is listed, these mark its faces.
#include "directional/cascades.glsl"

#if VCT_CASCADES > 1
const uint wordsPerBlock = VCT_PAGED_BLOCK_WORDS;
#else
const uint wordsPerBlock = VCT_BLOCK_WORDS;
#endif

// The number of a block, and the number of all blocks.
uint numberOfBlock(ivec3 block) {
    uint side = uint(frame.gridSide) / uint(VCT_BRICK_SIDE);
    return uint(block.x) + side * (uint(block.y) + side * uint(block.z));
}
uint blockCount() {
    uint side = uint(frame.gridSide) / uint(VCT_BRICK_SIDE);
    return side * side * side * uint(cascades);
}
// The position of a block's words of a face direction, where the triangles mark its faces.
uint markWords(ivec3 block, int face, bool isDynamic) {
    uint first = cascades == 1 && isDynamic ? 12u : 0u;
    return wordsPerBlock * numberOfBlock(block) + uint(2 * face) + first;
}
// The position of the word that has the position of a block's page; the word is 0 if the block has none.
// `block`: its number. Only with cascades.
uint pageAt(uint block) {
    return wordsPerBlock * block + 12u;
}
// The bit of a voxel in its block.
uint bitInBlock(ivec3 voxel) {
    return uint((voxel.x & 3) + 4 * (voxel.y & 3) + 16 * (voxel.z & 3));
}
// The number of words of all blocks.
uint allBlockWords() {
    return wordsPerBlock * blockCount();
}
