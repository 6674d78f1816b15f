#include "api/saved_state.h"

#include "shared/layout.h"

namespace vct {

namespace {

constexpr GLuint lastUnit = VCT_TEX_SHADOW_MOMENTS;  // the last texture unit that passes read

// Samplers of the embedding program would override the textures' own parameters.
void unbindSamplers() {
    for (GLuint unit = 0; unit <= lastUnit; ++unit)
        gl::BindSampler(unit, 0);
}

}  // namespace

SavedState::SavedState() {
    // The limit is needed because some drivers return errors for ever without a context.
    for (int i = 0; i < 8 && gl::GetError() != GL_NO_ERROR; ++i) {
    }
    for (std::size_t i = 0; i < switches.size(); ++i) {
        gl::GetIntegerv(switches[i], &enabled_[i]);
        if (enabled_[i] != GL_FALSE) gl::Disable(switches[i]);
    }
    gl::GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawFramebuffer_);
    gl::GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &readFramebuffer_);
    gl::GetIntegerv(GL_CURRENT_PROGRAM, &program_);
    gl::GetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertexArray_);
    gl::GetIntegerv(GL_ACTIVE_TEXTURE, &textureUnit_);
    gl::GetIntegerv(GL_BLEND_EQUATION_RGB, &blendEquation_);
    gl::GetIntegerv(GL_BLEND_EQUATION_ALPHA, &blendAlphaEquation_);
    gl::GetIntegerv(GL_BLEND_SRC_RGB, &blendSource_);
    gl::GetIntegerv(GL_BLEND_DST_RGB, &blendTarget_);
    gl::GetIntegerv(GL_BLEND_SRC_ALPHA, &blendAlphaSource_);
    gl::GetIntegerv(GL_BLEND_DST_ALPHA, &blendAlphaTarget_);
    gl::GetIntegerv(GL_DEPTH_WRITEMASK, &depthMask_);
    gl::GetIntegerv(GL_DEPTH_FUNC, &depthFunction_);
    gl::GetIntegerv(GL_CULL_FACE_MODE, &culledFace_);
    gl::GetIntegerv(GL_FRONT_FACE, &frontFace_);
    gl::GetIntegerv(GL_VIEWPORT, viewport_.data());
    gl::GetIntegerv(GL_SCISSOR_BOX, scissor_.data());
    gl::GetIntegerv(GL_COLOR_WRITEMASK, colorMask_.data());
    gl::GetFloatv(GL_DEPTH_RANGE, depthRange_.data());

    gl::ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl::DepthRangef(0.0F, 1.0F);
    unbindSamplers();
}

SavedState::~SavedState() {
    unbindSamplers();
    for (std::size_t i = 0; i < switches.size(); ++i)
        (enabled_[i] != GL_FALSE ? gl::Enable : gl::Disable)(switches[i]);
    gl::BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawFramebuffer_));
    gl::BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(readFramebuffer_));
    gl::UseProgram(static_cast<GLuint>(program_));
    gl::BindVertexArray(static_cast<GLuint>(vertexArray_));
    gl::ActiveTexture(static_cast<GLenum>(textureUnit_));
    gl::BlendEquationSeparate(static_cast<GLenum>(blendEquation_), static_cast<GLenum>(blendAlphaEquation_));
    gl::BlendFuncSeparate(static_cast<GLenum>(blendSource_), static_cast<GLenum>(blendTarget_),
                          static_cast<GLenum>(blendAlphaSource_), static_cast<GLenum>(blendAlphaTarget_));
    gl::DepthMask(static_cast<GLboolean>(depthMask_));
    gl::DepthFunc(static_cast<GLenum>(depthFunction_));
    gl::CullFace(static_cast<GLenum>(culledFace_));
    gl::FrontFace(static_cast<GLenum>(frontFace_));
    gl::Viewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    gl::Scissor(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
    gl::ColorMask(static_cast<GLboolean>(colorMask_[0]), static_cast<GLboolean>(colorMask_[1]),
                  static_cast<GLboolean>(colorMask_[2]), static_cast<GLboolean>(colorMask_[3]));
    gl::DepthRangef(depthRange_[0], depthRange_[1]);
}

}  // namespace vct
