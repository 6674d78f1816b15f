// Directional coverage voxels: six faces per voxel in one filterable 3D texture. Face f (a direction along an axis)
// holds, of the surface in the voxel that looks towards f: alpha, the share of the voxel's cross-section that it
// covers, and rgb, its radiance relative to E/pi over VCT_FACE_RADIANCE_RANGE, premultiplied by alpha. One-sided: a
// surface seen from behind neither lights nor blocks.
//
// The texture has 3 x 2 blocks of the grid: the axis along x, the side along y (0: towards +axis, 1: towards -axis).
#include "shared/layout.h"

// Of one face's block, in blocks.
ivec2 faceBlock(int axis, int side) {
    return ivec2(axis, side);
}

ivec3 faceTexel(ivec3 voxel, int axis, int side, int gridOfLevel) {
    return voxel + ivec3(faceBlock(axis, side) * gridOfLevel, 0);
}
