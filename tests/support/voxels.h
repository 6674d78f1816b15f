// Voxels that a test writes.
#pragma once

#include "lab/cpu_mips.h"

namespace vct::test {

// Replaces the base level; the other levels are computed on the CPU.
void writePyramid(const gl::Texture& voxels, Words base);

}  // namespace vct::test
