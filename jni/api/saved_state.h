// Saves and restores the GL state that include/vct/vct.h promises to leave unchanged.
#pragma once

#include <array>

#include "gl/api.h"

namespace vct {

// The constructor saves the state and sets the state that the engine's passes expect; the destructor restores
// it.
class SavedState {
  public:
    SavedState();
    ~SavedState();
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;

  private:
    static constexpr std::array<GLenum, 6> switches{
        GL_BLEND,        GL_CULL_FACE,           GL_DEPTH_TEST,
        GL_SCISSOR_TEST, GL_POLYGON_OFFSET_FILL, GL_RASTERIZER_DISCARD};

    std::array<GLint, switches.size()> enabled_{};
    GLint drawFramebuffer_ = 0, readFramebuffer_ = 0, program_ = 0, vertexArray_ = 0, textureUnit_ = 0;
    GLint blendEquation_ = 0, blendAlphaEquation_ = 0, blendSource_ = 0, blendTarget_ = 0;
    GLint blendAlphaSource_ = 0, blendAlphaTarget_ = 0;
    GLint depthMask_ = 0, depthFunction_ = 0, culledFace_ = 0, frontFace_ = 0;
    std::array<GLint, 4> viewport_{}, scissor_{}, colorMask_{};
    std::array<GLfloat, 2> depthRange_{};
};

}  // namespace vct
