// Computes the mip levels of the packed voxels, over the active-voxel lists only (thesis 4.5).
#pragma once

#include "engine/voxel_pyramid.h"

namespace vct {

gl::ProgramDescription packedMipmapperProgram();

class PackedMipmapper {
  public:
    explicit PackedMipmapper(const gl::ShaderLibrary& shaders);

    // Afterwards shaders can fetch the voxels as a texture, and draws can read the lists.
    void run(VoxelPyramid& voxels);

  private:
    gl::Program program_;
};

}  // namespace vct
