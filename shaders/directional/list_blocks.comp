// Lists the static faces of all blocks, after scroll.comp. Only with cascades.
#include "directional/block_lists.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

void main() {
    ivec3 block = ivec3(gl_GlobalInvocationID);
    int side = frame.gridSide / VCT_BRICK_SIDE;
    if (any(greaterThanEqual(block, ivec3(side, side, side * cascades)))) return;
    uint shift, at = maskAt(block, shift);
    listOfBlock(block, faceData[at] >> shift & VCT_FACE_MASK);
}
