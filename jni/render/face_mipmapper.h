// Every level of the directional coverage voxels from the one below, over the occupied voxels only.
#pragma once

#include "render/face_voxels.h"

namespace vct {

class FaceMipmapper {
  public:
    explicit FaceMipmapper(const gl::ShaderLibrary& shaders);

    // Afterwards the faces are ready to be fetched as a texture.
    void run(FaceVoxels& voxels);

  private:
    gl::Program parents_, mipmap_;
};

}  // namespace vct
