// Computes the mip levels of the directional voxels, over the face lists only.
#pragma once

#include "engine/directional/directional_voxels.h"

namespace vct {

gl::ProgramDescription directionalMipmapperProgram();

class DirectionalMipmapper {
  public:
    explicit DirectionalMipmapper(const gl::ShaderLibrary& shaders);

    // Computes all levels above the base level. Afterwards shaders can fetch the faces as a texture.
    // `frameIndex` seeds the dither.
    void run(const DirectionalVoxels& voxels, std::uint32_t frameIndex) const;

  private:
    gl::Program program_;
};

}  // namespace vct
