#include "support/surface_pixels.h"

#include <cmath>

#include "engine/programs.h"
#include "lab/debug_view.h"
#include "lab/read_back.h"

namespace vct::test {

namespace {

// ES cannot read a depth texture; the depth view writes it into a colour target.
Image readDepth(const gl::ShaderLibrary& shaders, const gl::Texture& depth) {
    depth.bind(VCT_TEX_G_DEPTH);
    const gl::Program program(shaders, debugViewProgram(VCT_DEBUG_VIEW_DEPTH));
    const gl::Texture color = gl::Texture::make2d("depth", GL_RGBA32F, depth.width(), depth.height());
    const gl::Framebuffer framebuffer("depth", {&color}, nullptr);
    const gl::VertexArray noVertices;
    framebuffer.bind();
    gl::Disable(GL_DEPTH_TEST);
    program.use();
    noVertices.bind();
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
    return readImage(color);
}

// Four numbers per pixel, the bottom row first.
template <class Number>
std::vector<Number> readRgba(const gl::Texture& texture, GLenum format, GLenum type) {
    const gl::Framebuffer framebuffer("read back", {&texture}, nullptr);
    framebuffer.bind();
    gl::ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl::PixelStorei(GL_PACK_ALIGNMENT, 4);
    std::vector<Number> numbers(static_cast<std::size_t>(texture.width()) * texture.height() * 4);
    gl::ReadPixels(0, 0, texture.width(), texture.height(), format, type, numbers.data());
    return numbers;
}

// Cigolle et al. 2014: the octahedron unfolded into a square, two coordinates of 0..65534.
glm::dvec3 normalFromCode(std::uint32_t codeX, std::uint32_t codeY) {
    const double x = codeX / 32767.0 - 1.0;
    const double y = codeY / 32767.0 - 1.0;
    const double z = 1.0 - std::abs(x) - std::abs(y);
    if (z >= 0.0) return glm::normalize(glm::dvec3(x, y, z));
    return glm::normalize(
        glm::dvec3(std::copysign(1.0 - std::abs(y), x), std::copysign(1.0 - std::abs(x), y), z));
}

}  // namespace

std::vector<SurfacePixel> surfacePixels(const gl::ShaderLibrary& shaders, const GBuffer::Targets& targets,
                                        const shared::FrameUniforms& frame) {
    const Image depth = readDepth(shaders, *targets.depth);
    const auto normals = readRgba<std::uint32_t>(*targets.normal, GL_RGBA_INTEGER, GL_UNSIGNED_INT);
    const auto roots = readRgba<std::uint8_t>(*targets.albedo, GL_RGBA, GL_UNSIGNED_BYTE);
    std::vector<SurfacePixel> pixels(depth.pixels.size());
    for (int y = 0; y < depth.height; ++y)
        for (int x = 0; x < depth.width; ++x) {
            const float z = depth.at(x, y).x;
            if (z == 1.0F) continue;
            const glm::dvec4 p =
                glm::dmat4(frame.volumeFromWindow) * glm::dvec4(x + 0.5, depth.height - (y + 0.5), z, 1.0);
            const std::size_t fromBottom =
                (static_cast<std::size_t>(depth.height - 1 - y) * depth.width + x) * 4;
            SurfacePixel& pixel = pixels[static_cast<std::size_t>(y) * depth.width + x];
            pixel.surface = true;
            pixel.positionVolume = glm::dvec3(p) / p.w;
            pixel.normal = normalFromCode(normals[fromBottom], normals[fromBottom + 1]);
            const glm::dvec3 root =
                glm::dvec3(roots[fromBottom], roots[fromBottom + 1], roots[fromBottom + 2]) / 255.0;
            pixel.albedo = root * root;
        }
    return pixels;
}

}  // namespace vct::test
