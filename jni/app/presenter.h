// A frame into the window.
#pragma once

#include "engine/renderer.h"
#include "gl/program.h"

namespace vct::app {

class Presenter {
  public:
    explicit Presenter(const gl::ShaderLibrary& shaders);

    // Scales the renderer's last frame to the window that is current, `window` pixels, exposes and tone-maps
    // it, and encodes it as sRGB: the picture that a PNG of it holds. A frame of another shape keeps it, with
    // black beside it.
    void draw(const Renderer& renderer, glm::ivec2 window, float exposure) const;

  private:
    gl::Program program_;
    gl::VertexArray noVertices_;
};

// All of the window that is current in one sRGB-encoded colour.
void clearWindow(glm::ivec2 window, const glm::vec3& color);

}  // namespace vct::app
