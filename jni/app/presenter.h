// A frame into the window.
#pragma once

#include "engine/renderer.h"
#include "gl/program.h"
#include "gl/render_pass.h"

namespace vct::app {

// Of a scene: as that of `vct render` by its first picture, and again by the one in which its light stands
// still. Then it stays, so that a light that is switched off is seen to be off; and reading a picture back
// takes too long for every frame.
class Exposure {
  public:
    // After each frame.
    void follow(const Renderer& renderer);
    float value() const { return value_; }

  private:
    float value_ = 1.0F;
    int frames_ = 0;
};

class Presenter {
  public:
    explicit Presenter(const gl::ShaderLibrary& shaders);

    // Scales the renderer's last frame to the window of the current pass, `window` pixels, multiplies it by
    // the exposure, and maps and encodes it for the screen: the picture that a PNG of it holds. A frame of
    // another shape keeps it and leaves the rest of the window alone.
    void draw(const Renderer& renderer, float exposure, glm::ivec2 window) const;

  private:
    gl::Program program_;
    gl::VertexArray noVertices_;
};

// The pass that draws the current window. It starts with one sRGB-encoded colour.
gl::RenderPass windowPass(glm::ivec2 window, const glm::vec3& color);

}  // namespace vct::app
