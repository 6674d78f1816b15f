// Depth of the scene from the light (thesis 4.2).
#pragma once

#include "gl/objects.h"
#include "render/gpu_scene.h"

namespace vct {

class ShadowMap {
  public:
    ShadowMap(const gl::ShaderLibrary& shaders, const GpuScene& scene, int size);

    // Returns the depth texture: compare function LEQUAL, hardware filter, ready to be sampled.
    const gl::Texture& draw(const GpuScene& scene);

    const gl::Texture& texture() const { return depth_; }

  private:
    MaterialPrograms programs_;
    gl::Texture depth_;
    gl::Framebuffer framebuffer_;
};

}  // namespace vct
