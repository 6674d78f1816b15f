// Every level of the directional coverage voxels from the one below, over the occupied voxels only.
#pragma once

#include "render/face_voxels.h"

namespace vct {

class FaceMipmapper {
  public:
    explicit FaceMipmapper(const gl::ShaderLibrary& shaders);

    // The lists of every level from the base level's.
    void makeLists(const FaceVoxels& voxels);
    // The faces of every level from `first` on from the level below. Afterwards they are ready to be fetched
    // as a texture.
    void run(const FaceVoxels& voxels, int first = 1);

  private:
    gl::Program parents_, mipmap_;
};

}  // namespace vct
