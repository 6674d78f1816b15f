// The blocks of voxels that a frame makes anew (jni/engine/directional/dirty_blocks.h).
#include "directional/blocks.glsl"

layout(std140, binding = VCT_UBO_CHANGED_BLOCKS) uniform DirtyBlocks {
    uvec4 changedRows[VCT_BLOCKS * VCT_BLOCKS / 4];
};

bool isChanged(ivec3 voxel) {
    ivec3 block = voxel * VCT_BLOCKS / frame.grid.x;
    int row = block.z * VCT_BLOCKS + block.y;
    return (changedRows[row >> 2][row & 3] >> uint(block.x) & 1u) != 0u;
}
