// Reads pictures and voxels back from GL, for files and tests; each call waits for the GPU.
#pragma once

#include <cstdint>
#include <vector>

#include "gl/objects.h"
#include "image/image.h"

namespace vct {

// rgb of an RGBA16F or RGBA32F texture, row 0 at the top, times `scale`.
Image readImage(const gl::Texture& texture, float scale = 1.0F);

// All words of one level of an R32UI 3D texture, x fastest, then y, then z.
std::vector<std::uint32_t> readVoxels(const gl::Texture& voxels, int level);

}  // namespace vct
