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

// Tone mapping and edge smoothing run once per pixel of the frame. Only scaling runs once per pixel of the
// window, so that the automatic resolution lowers most of the cost of presenting too.
class Presenter {
  public:
    explicit Presenter(const gl::ShaderLibrary& shaders);

    // Makes the picture that draw() shows, from the renderer's last frame: applies exposure, tone mapping and
    // sRGB encoding as for a PNG, and smooths its edges unless draw() does. Must be called outside of a
    // render pass.
    void prepare(const Renderer& renderer, float exposure, glm::ivec2 window);
    // Scales the picture to the window of the current pass (`window` pixels, as in prepare()). A frame with
    // another aspect ratio keeps it; the rest of the window is not touched.
    void draw(glm::ivec2 window) const;

    // Uses one more of the programs in a frame without a picture, because some drivers compile a program when
    // it is first used. Must be called outside of a render pass.
    void useNext();

    void dropTargets() {
        frameSize_ = glm::ivec2(0);
        toneMapped_ = {};
        smoothed_ = {};
    }

  private:
    // A picture of the frame's size.
    struct Target {
        gl::Texture texture;
        gl::Framebuffer framebuffer;
    };
    static Target makeTarget(const char* label, glm::ivec2 size);

    gl::Program toneMap_, smooth_, scale_;
    gl::VertexArray noVertices_;
    glm::ivec2 frameSize_{0};
    Target toneMapped_;
    Target smoothed_;  // empty where the window has as many pixels as the frame
    int used_ = 0;     // programs that useNext() has used
};

// The render pass of the current window. It first clears the window to an sRGB-encoded colour.
gl::RenderPass windowPass(glm::ivec2 window, const glm::vec3& color);

}  // namespace vct::app
