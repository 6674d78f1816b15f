// Every level of the directional voxels from the one below, over the faces that are not empty.
#pragma once

#include "engine/directional/directional_voxels.h"

namespace vct {

gl::ProgramDescription directionalMipmapperProgram();

class DirectionalMipmapper {
  public:
    explicit DirectionalMipmapper(const gl::ShaderLibrary& shaders);

    // The levels above the base level. Afterwards the faces are ready to be fetched as a texture.
    // `frameIndex` seeds the dither.
    void run(const DirectionalVoxels& voxels, std::uint32_t frameIndex) const;

  private:
    gl::Program program_;
};

}  // namespace vct
