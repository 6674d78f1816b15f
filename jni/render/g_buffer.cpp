#include "render/g_buffer.h"

#include "gl/debug.h"
#include "render/programs.h"

namespace vct {

GBuffer::GBuffer(const gl::ShaderLibrary& shaders, const GpuScene& scene, glm::ivec2 size)
    : programs_(shaders, scene,
                [emits = scene.hasEmission()](unsigned features) { return gBufferProgram(features, emits); }),
      albedo_(gl::Texture::make2d("G-buffer albedo", GL_RGBA8, size.x, size.y)),
      normal_(gl::Texture::make2d("G-buffer normal", GL_RG16UI, size.x, size.y)),
      depth_(gl::Texture::make2d("G-buffer depth", GL_DEPTH_COMPONENT32F, size.x, size.y)) {
    if (scene.hasEmission()) {
        emissive_ = gl::Texture::make2d("G-buffer emissive", GL_RGBA16F, size.x, size.y);
        framebuffer_ = gl::Framebuffer("G-buffer", {&albedo_, &normal_, &*emissive_}, &depth_);
    } else {
        framebuffer_ = gl::Framebuffer("G-buffer", {&albedo_, &normal_}, &depth_);
    }
}

GBuffer::Targets GBuffer::draw(const GpuScene& scene) {
    const gl::DebugGroup group("G-buffer");
    framebuffer_.bind();
    gl::Enable(GL_DEPTH_TEST);
    gl::DepthFunc(GL_LESS);
    gl::DepthMask(GL_TRUE);
    const float black[4] = {0.0F, 0.0F, 0.0F, 0.0F};
    const GLuint zero[4] = {0, 0, 0, 0};
    const float far = 1.0F;
    gl::ClearBufferfv(GL_COLOR, 0, black);
    gl::ClearBufferuiv(GL_COLOR, 1, zero);
    if (emissive_) gl::ClearBufferfv(GL_COLOR, 2, black);
    gl::ClearBufferfv(GL_DEPTH, 0, &far);
    scene.draw(GpuScene::Culling::backFaces, programs_);
    return targets();
}

GBuffer::Targets GBuffer::targets() const {
    return {&albedo_, &normal_, emissive_ ? &*emissive_ : nullptr, &depth_};
}

}  // namespace vct
