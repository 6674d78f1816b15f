// Reads pictures and voxels back from GL, for files and tests. Each call waits for the GPU.
#pragma once

#include <cstdint>
#include <vector>

#include "gl/objects.h"
#include "image/image.h"

namespace vct {

// Reads the rgb of an RGBA16F or RGBA32F texture, multiplied by `scale`. Row 0 of the result is at the top.
Image readImage(const gl::Texture& texture, float scale = 1.0F);

// Reads all words of one level of an R32UI 3D texture: x varies fastest, then y, then z.
std::vector<std::uint32_t> readVoxels(const gl::Texture& voxels, int level);

}  // namespace vct
