#include "app/presenter.h"

#include <algorithm>
#include <cmath>

#include "app/app_programs.h"
#include "gl/debug.h"
#include "image/tone_map.h"

namespace vct::app {

namespace {

// Bindings and locations in app/present.frag.
constexpr int radianceUnit = 0;
constexpr GLint scaleUniform = 0;
constexpr GLint rectangleUniform = 1;

// The part of the window that shows the frame: origin and size. Differences of the aspect ratio by rounding
// are ignored.
glm::ivec4 rectangleFor(glm::ivec2 frame, glm::ivec2 window) {
    const glm::dvec2 ratio = glm::dvec2(window) / glm::dvec2(frame);
    glm::ivec2 size = window;
    if (std::abs(ratio.x / ratio.y - 1.0) > 0.02)
        size = glm::max(glm::ivec2(glm::dvec2(frame) * std::min(ratio.x, ratio.y)), glm::ivec2(1));
    return {(window - size) / 2, size};
}

}  // namespace

void Exposure::follow(const Renderer& renderer) {
    const Settings& settings = renderer.settings();
    if (frames_ == 0 || frames_ == settings.lightFrames) {
        const Image image = renderer.radiance();
        value_ = automaticExposure(
            settings.background ? withSky(image, *settings.background, settings.skyRadiance) : image);
    }
    ++frames_;
}

Presenter::Presenter(const gl::ShaderLibrary& shaders) : program_(shaders, presentProgram()) {}

void Presenter::draw(const Renderer& renderer, float exposure, glm::ivec2 window) const {
    const gl::DebugGroup group("present");
    const gl::Texture& frame = renderer.output();
    const glm::ivec4 rectangle = rectangleFor({frame.width(), frame.height()}, window);
    frame.setFilter(GL_LINEAR, GL_LINEAR);
    gl::Viewport(rectangle.x, rectangle.y, rectangle.z, rectangle.w);
    program_.use();
    frame.bind(radianceUnit);
    const glm::vec4 r(rectangle);
    gl::Uniform4f(scaleUniform, exposure * renderer.radianceScale(), 0.0F, 0.0F, 0.0F);
    gl::Uniform4f(rectangleUniform, r.x, r.y, r.z, r.w);
    noVertices_.bind();
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
}

gl::RenderPass windowPass(glm::ivec2 window, const glm::vec3& color) {
    return gl::RenderPass(gl::Framebuffer::window(window.x, window.y), gl::Load::clear, gl::Store::colors,
                          {color.r, color.g, color.b, 1.0F});
}

}  // namespace vct::app
