// What the GPU's voxels must be, computed plainly on the CPU.
#pragma once

#include <cstdint>
#include <vector>

#include "render/voxel_pyramid.h"

namespace vct::test {

using Words = std::vector<std::uint32_t>;  // of one level, x fastest, then y, then z

// The next level of a level of `side` voxels per side, by thesis 4.5.
Words mipOnCpu(const Words& words, int side);

// Replaces one level of the texture.
void writeLevel(const gl::Texture& voxels, int level, const Words& words);

// Replaces the base level and gives every other level its CPU mip.
void writePyramid(const gl::Texture& voxels, Words base);

// The entries of a level's active-voxel list, `count` of them.
std::vector<std::uint32_t> readEntries(const VoxelPyramid& pyramid, int level, std::uint32_t count);

}  // namespace vct::test
