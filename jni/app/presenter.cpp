#include "app/presenter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/app_programs.h"
#include "gl/debug.h"
#include "image/tone_map.h"

namespace vct::app {

namespace {

// Bindings and locations in app/tone_map.frag, smooth.frag and scale.frag.
constexpr int frameUnit = 0;
constexpr GLint exposureUniform = 0;
constexpr GLint rectangleUniform = 0;

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

Presenter::Presenter(const gl::ShaderLibrary& shaders)
    : toneMap_(shaders, toneMapProgram()),
      smooth_(shaders, smoothProgram()),
      scale_(shaders, scaleProgram()) {}

Presenter::Target Presenter::makeTarget(const char* label, glm::ivec2 size) {
    Target target;
    target.texture = gl::Texture::make2d(label, GL_RGBA8, size.x, size.y);
    target.texture.setFilter(GL_LINEAR, GL_LINEAR);
    target.framebuffer = gl::Framebuffer(label, {&target.texture}, nullptr);
    return target;
}

void Presenter::prepare(const Renderer& renderer, float exposure, glm::ivec2 window) {
    const gl::DebugGroup group("present");
    const gl::Texture& radiance = renderer.output();
    const glm::ivec2 size(radiance.width(), radiance.height());
    if (size != frameSize_) {
        dropTargets();
        toneMapped_ = makeTarget("tone-mapped frame", size);
        frameSize_ = size;
    }
    noVertices_.bind();
    {
        const gl::RenderPass pass(toneMapped_.framebuffer, gl::Load::invalidate);
        toneMap_.use();
        radiance.bind(frameUnit);
        gl::Uniform4f(exposureUniform, exposure * renderer.radianceScale(), 0.0F, 0.0F, 0.0F);
        gl::DrawArrays(GL_TRIANGLES, 0, 3);
    }
    if (frameSize_ == window) return;
    if (smoothed_.texture.name() == 0) smoothed_ = makeTarget("smoothed frame", size);
    const gl::RenderPass pass(smoothed_.framebuffer, gl::Load::invalidate);
    smooth_.use();
    toneMapped_.texture.bind(frameUnit);
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
}

void Presenter::draw(glm::ivec2 window) const {
    const gl::DebugGroup group("present");
    noVertices_.bind();
    if (frameSize_ == window) {
        smooth_.use();
        toneMapped_.texture.bind(frameUnit);
    } else {
        const glm::ivec4 r = rectangleFor(frameSize_, window);
        gl::Viewport(r.x, r.y, r.z, r.w);
        scale_.use();
        smoothed_.texture.bind(frameUnit);
        gl::Uniform4f(rectangleUniform, static_cast<float>(r.x), static_cast<float>(r.y),
                      1.0F / static_cast<float>(r.z), 1.0F / static_cast<float>(r.w));
    }
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
}

// Each draws a few pixels. llvmpipe compiles other code for sides that are powers of two.
void Presenter::useNext() {
    const std::array<const gl::Program*, 3> programs{&toneMap_, &smooth_, &scale_};
    if (used_ == static_cast<int>(programs.size())) return;
    const gl::Texture source =
        gl::Texture::make2d("source of a first use", used_ == 0 ? GL_RGBA16F : GL_RGBA8, 3, 3);
    source.setFilter(GL_LINEAR, GL_LINEAR);
    const Target target = makeTarget("target of a first use", glm::ivec2(3));
    noVertices_.bind();
    const gl::RenderPass pass = programs[used_] == &scale_
                                    ? windowPass(glm::ivec2(3), glm::vec3(0.0F))
                                    : gl::RenderPass(target.framebuffer, gl::Load::invalidate);
    programs[used_]->use();
    source.bind(frameUnit);
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
    ++used_;
}

gl::RenderPass windowPass(glm::ivec2 window, const glm::vec3& color) {
    return gl::RenderPass(gl::Framebuffer::window(window.x, window.y), gl::Load::clear, gl::Store::colors,
                          {color.r, color.g, color.b, 1.0F});
}

}  // namespace vct::app
