// The blocks of voxels that a frame makes anew, where something moves (jni/engine/directional/dirty_blocks.h).
#include "shared/frame.glsl"

layout(std140, binding = VCT_UBO_DIRTY_BLOCKS) uniform DirtyBlocks {
    uvec4 dirtyRows[VCT_BLOCKS * VCT_BLOCKS / 4];
};

bool isDirty(ivec3 voxel) {
    ivec3 block = voxel * VCT_BLOCKS / frame.gridSide;
    int row = block.z * VCT_BLOCKS + block.y;
    return (dirtyRows[row >> 2][row & 3] >> uint(block.x) & 1u) != 0u;
}
