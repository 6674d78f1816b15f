// What the GPU's mip levels and lists must be, computed plainly on the CPU.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/voxel_pyramid.h"

namespace vct {

using Words = std::vector<std::uint32_t>;  // of one level, x fastest, then y, then z

// The next level of a level of `side` voxels per side, by thesis 4.5.
Words mipOnCpu(const Words& words, int side);

// The entries that a level's list must hold, in ascending order.
std::vector<std::uint32_t> entriesOnCpu(const Words& words, int side);

// The entries of a level's active-voxel list on the GPU, `count` of them.
std::vector<std::uint32_t> readEntries(const VoxelPyramid& pyramid, int level, std::uint32_t count);

}  // namespace vct
