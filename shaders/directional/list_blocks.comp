// Lists the static faces of all blocks, after scroll.comp, and gives the blocks that have come to other
// places of their cascades their pages. Those of blocks that have left are free from now on.
// unlist_static.comp has copied the positions of the pages to where the marked blocks are listed. Only with
// cascades.
#include "directional/block_lists.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

layout(location = VCT_UNIFORM_SHIFT) uniform uint shifts[VCT_MAX_CASCADES];  // packShift() of each cascade

uint lastPageOf(ivec3 block) {
    return activeVoxels[commands[VCT_BRICK_LEVEL].firstEntry + numberOfBlock(block)];
}
void freePage(uint page) {
    for (uint word = 0u; word < VCT_PAGE_WORDS; ++word)
        faceData[page + word] = 0u;
    faceData[firstFreePage + atomicAdd(freePages, 1u)] = page;
}
void movePages(ivec3 block, int side) {
    ivec3 blocks = unpackShift(shifts[block.z / side]) >> VCT_BRICK_LEVEL;
    if (blocks == ivec3(0)) return;
    ivec3 before = block + blocks, now = block - blocks;
    faceData[pageAt(numberOfBlock(block))] =
        before == clampToCascade(before, block, side) ? lastPageOf(before) : 0u;
    uint page = lastPageOf(block);
    if (page != 0u && now != clampToCascade(now, block, side)) freePage(page);
}

void main() {
    ivec3 block = ivec3(gl_GlobalInvocationID);
    int side = frame.gridSide / VCT_BRICK_SIDE;
    if (any(greaterThanEqual(block, ivec3(side, side, side * cascades)))) return;
    uint shift, at = maskAt(block, shift);
    listOfBlock(block, faceData[at] >> shift & VCT_FACE_MASK);
    movePages(block, side);
}
