// Every level of the directional coverage voxels from the one below, over the occupied voxels only.
#pragma once

#include "engine/directional/directional_voxels.h"

namespace vct {

gl::ProgramDescription directionalLevelsProgram();
gl::ProgramDescription directionalMipmapperProgram();

class DirectionalMipmapper {
  public:
    explicit DirectionalMipmapper(const gl::ShaderLibrary& shaders);

    // The faces of every level above the base level, from its own list, and the lists of the levels above.
    // Afterwards the faces are ready to be fetched as a texture.
    void makeLevels(const DirectionalVoxels& voxels);
    // Likewise where all lists are there. `which`: time it is that the same faces are stored.
    void update(const DirectionalVoxels& voxels, std::uint32_t which);

  private:
    gl::Program levels_, mipmap_;
};

}  // namespace vct
