// Voxels that a test writes itself.
#pragma once

#include "lab/cpu_mips.h"

namespace vct::test {

// Replaces the base level and gives every other level its CPU mip.
void writePyramid(const gl::Texture& voxels, Words base);

}  // namespace vct::test
