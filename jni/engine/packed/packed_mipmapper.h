// Every level of the voxels from the one below, over the active voxels only (thesis 4.5).
#pragma once

#include "engine/voxel_pyramid.h"

namespace vct {

gl::ProgramDescription packedMipmapperProgram();

class PackedMipmapper {
  public:
    explicit PackedMipmapper(const gl::ShaderLibrary& shaders);

    // Afterwards the pyramid is ready to be fetched as a texture, and the lists to be drawn.
    void run(VoxelPyramid& voxels);

  private:
    gl::Program program_;
};

}  // namespace vct
