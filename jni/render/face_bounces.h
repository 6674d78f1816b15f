// Further bounces of light: the voxels gather at their own surfaces, and shine with what they got.
#pragma once

#include "render/face_mipmapper.h"
#include "render/settings.h"

namespace vct {

class FaceBounces {
  public:
    FaceBounces(const gl::ShaderLibrary& shaders, const GatherSettings& pixels);

    // Adds `count` bounces to the direct light of the faces, every level of which must be there.
    void run(int count, FaceVoxels& voxels, FaceMipmapper& mipmapper);

    // Empty before the first bounce.
    const gl::Buffer& light() const { return light_; }

  private:
    void reserveLight(const FaceVoxels& voxels);

    gl::Program gather_, apply_;
    gl::Buffer light_;  // shaders/shared/face_bounce.glsl
};

}  // namespace vct
