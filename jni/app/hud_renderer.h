// Draws Dear ImGui's triangles through gl::, because ImGui's own back ends load desktop OpenGL. It needs only
// OpenGL ES 3.0, so that the app can show what a driver lacks.
#pragma once

#include <imgui.h>

#include <glm/glm.hpp>

#include "gl/program.h"

namespace vct::app {

class HudRenderer {
  public:
    // The font atlas is that of the current ImGui context, whose size may change.
    explicit HudRenderer(const gl::ShaderLibrary& shaders);

    // Draws into the window's render pass (windowPass() in app/presenter.h), `window` pixels in size.
    // Blending and the scissor test are off before and after.
    void draw(const ImDrawData& data, glm::ivec2 window);

  private:
    gl::Program program_;
    GLint windowUniform_;
    gl::Texture font_;
    float fontSize_ = 0.0F;  // that font_ was made for
    gl::VertexArray vertexArray_;
    gl::Buffer vertices_, indices_;
};

}  // namespace vct::app
