#include "render/shadow_map.h"

#include "gl/debug.h"
#include "render/programs.h"

namespace vct {

ShadowMap::ShadowMap(const gl::ShaderLibrary& shaders, const GpuScene& scene, int size)
    : programs_(shaders, scene, shadowMapProgram),
      depth_(gl::Texture::make2d("shadow map", GL_DEPTH_COMPONENT24, size, size)),
      framebuffer_("shadow map", {}, &depth_) {
    depth_.setFilter(GL_LINEAR, GL_LINEAR);  // with a comparison: four taps, weighted
    depth_.setParameter(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    depth_.setParameter(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

const gl::Texture& ShadowMap::draw(const GpuScene& scene) {
    const gl::DebugGroup group("shadow map");
    framebuffer_.bind();
    gl::Enable(GL_DEPTH_TEST);
    gl::DepthFunc(GL_LESS);
    gl::DepthMask(GL_TRUE);
    const float far = 1.0F;
    gl::ClearBufferfv(GL_DEPTH, 0, &far);
    // Single-sided surfaces cast shadows from both sides, as they do in a path tracer.
    scene.draw(GpuScene::Culling::none, programs_);
    return depth_;
}

}  // namespace vct
