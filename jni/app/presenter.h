// Shows a rendered frame in the window.
#pragma once

#include "engine/renderer.h"
#include "gl/program.h"
#include "gl/render_pass.h"

namespace vct::app {

// The exposure of a scene, chosen as `vct render` does: by the first picture, and again by the one after
// lightFrames frames, when indirect light has converged. Then it stays fixed, so that switching a light off
// makes the picture darker, and because reading a picture back in every frame would take too long.
class Exposure {
  public:
    // Must be called after each frame.
    void follow(const Renderer& renderer);
    float value() const { return value_; }

  private:
    float value_ = 1.0F;
    int frames_ = 0;
};

class Presenter {
  public:
    explicit Presenter(const gl::ShaderLibrary& shaders);

    // Scales the renderer's last frame to the window of the current pass (`window` pixels), and applies
    // exposure, tone mapping and sRGB encoding, as for a PNG. A frame with another aspect ratio keeps it; the
    // rest of the window is not touched.
    void draw(const Renderer& renderer, float exposure, glm::ivec2 window) const;

  private:
    gl::Program program_;
    gl::VertexArray noVertices_;
};

// The render pass of the current window. It first clears the window to an sRGB-encoded colour.
gl::RenderPass windowPass(glm::ivec2 window, const glm::vec3& color);

}  // namespace vct::app
