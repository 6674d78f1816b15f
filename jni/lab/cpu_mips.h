// Computes mip levels and active-voxel lists of packed voxels on the CPU, to check the GPU's.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/voxel_pyramid.h"

namespace vct {

using Words = std::vector<std::uint32_t>;  // packed voxels of one level, x fastest, then y, then z

// Returns the next coarser level of a level with `side` voxels per side (thesis 4.5).
Words mipOnCpu(const Words& words, int side);

// Returns the entries that a level's active-voxel list must have, in ascending order.
std::vector<std::uint32_t> entriesOnCpu(const Words& words, int side);

// Reads the `count` entries of a level's active-voxel list from the GPU.
std::vector<std::uint32_t> readEntries(const VoxelPyramid& pyramid, int level, std::uint32_t count);

}  // namespace vct
