#include "support/frame_inspector.h"

#include <algorithm>
#include <cmath>

#include "engine/frame_uniforms.h"
#include "engine/programs.h"
#include "gl/read_back.h"
#include "lab/debug_view.h"
#include "support/renderers.h"
#include "support/scenes.h"

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

std::vector<SurfacePixel> readSurface(Renderer& renderer, const shared::FrameUniforms& frame) {
    const GBuffer::Targets targets = renderer.surface();
    const Image depth = readDepth(renderer.shaders(), *targets.depth);
    const auto normals = readRgba<std::uint32_t>(*targets.normal, GL_RGBA_INTEGER, GL_UNSIGNED_INT);
    const auto roots = readRgba<std::uint8_t>(*targets.albedo, GL_RGBA, GL_UNSIGNED_BYTE);
    const glm::dmat4 worldFromVolume = glm::inverse(renderer.volume().volumeFromWorld());
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
            pixel.positionWorld = glm::dvec3(worldFromVolume * glm::dvec4(pixel.positionVolume, 1.0));
            // shaders/shared/normals.glsl has the codes.
            const std::uint32_t* const code = &normals[fromBottom];
            pixel.normal = targets.mappedNormals ? normalFromCode(code[2], code[3], 65534.0)
                                                 : normalFromCode(code[0] & 4095U, code[1] & 4095U, 4094.0);
            const glm::dvec3 root =
                glm::dvec3(roots[fromBottom], roots[fromBottom + 1], roots[fromBottom + 2]) / 255.0;
            pixel.albedo = root * root;
        }
    return pixels;
}

}  // namespace

glm::dvec3 normalFromCode(std::uint32_t codeX, std::uint32_t codeY, double steps) {
    const double x = codeX / steps * 2.0 - 1.0;
    const double y = codeY / steps * 2.0 - 1.0;
    const double z = 1.0 - std::abs(x) - std::abs(y);
    if (z >= 0.0) return glm::normalize(glm::dvec3(x, y, z));
    return glm::normalize(
        glm::dvec3(std::copysign(1.0 - std::abs(y), x), std::copysign(1.0 - std::abs(x), y), z));
}

void Spread::add(double value) {
    mean = (mean * count + value) / (count + 1);
    min = std::min(min, value);
    max = std::max(max, value);
    ++count;
}

Bounds boundsForVoxelsAsWorld(int grid) {
    return {glm::dvec3(2.5), glm::dvec3(grid - 2.5)};
}

FrameInspector::FrameInspector(const Context& context, Scene scene, const DirectionalLight& light,
                               const Settings& settings, const Camera& camera)
    : scene_(std::move(scene)),
      light_(light),
      settings_(settings),
      camera_(camera),
      renderer_(makeRenderer(context, scene_, light, settings)) {}

void FrameInspector::setLight(const glm::dvec3& directionToLight) {
    light_.directionToLight = glm::normalize(directionToLight);
    renderer_.setLightDirection(light_.directionToLight);
}

Image FrameInspector::view(Output output) {
    return view(output, output != Output::indirectLight);
}

Image FrameInspector::view(Output output, bool allBounces) {
    renderer_.render({{output}, camera_, LightSteps::all, nullptr, allBounces});
    return readImage(renderer_.output());
}

std::vector<SeenSurface> FrameInspector::seen(Output output) {
    const Image image = view(output);
    std::vector<SeenSurface> surfaces;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (pixels()[i].surface) surfaces.push_back({pixels()[i], image.pixels[i]});
    return surfaces;
}

std::vector<float> FrameInspector::mode2Shadow() {
    // Mode 2 removes 0.9 of all light of mode 1 but a constant 0.05.
    const Image lit = view(Output::phong), shadowed = view(Output::shadowMap);
    std::vector<float> shares;
    for (std::size_t i = 0; i < lit.pixels.size(); ++i) {
        const float all = lit.pixels[i].x - 0.05F;
        shares.push_back(all > 1e-3F ? 1.0F - (lit.pixels[i].x - shadowed.pixels[i].x) / (0.9F * all) : 0.0F);
    }
    return shares;
}

std::vector<float> FrameInspector::hardShadow() {
    pixels();
    const Image all = view(Output::gi);
    const Image indirect = view(Output::indirectLight, true);
    std::vector<float> light(all.pixels.size());
    for (std::size_t i = 0; i < light.size(); ++i) {
        if (!pixels_[i].surface) continue;
        const double cosine = glm::dot(pixels_[i].normal, light_.directionToLight) * pixels_[i].albedo.x;
        if (cosine > 1e-3) light[i] = static_cast<float>((all.pixels[i].x - indirect.pixels[i].x) / cosine);
    }
    return light;
}

std::vector<float> FrameInspector::softShadow() {
    std::vector<float> light;
    for (const Image image = view(Output::sunVisibility); const glm::vec3& pixel : image.pixels)
        light.push_back(pixel.x);
    return light;
}

const std::vector<SurfacePixel>& FrameInspector::pixels() {
    if (pixels_.empty()) {
        renderer_.render({{Output::phong}, camera_});
        pixels_ = readSurface(renderer_, frameUniforms(camera_, light_, renderer_.radianceScale(),
                                                       scene_.boundsWorld, renderer_.volume(), settings_));
    }
    return pixels_;
}

Spread FrameInspector::spreadOf(Output output) {
    Spread spread;
    for (const SeenSurface& pixel : seen(output))
        spread.add(pixel.value.x);
    return spread;
}

Words FrameInspector::packedVoxels() {
    view(Output::gi);
    return readVoxels(renderer_.occupancy().texture(), 0);
}

void FrameInspector::replacePackedVoxels(Words base) {
    const gl::Texture& voxels = renderer_.occupancy().texture();
    voxels.bind(VCT_TEX_VOXELS);
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    for (int level = 0; level < voxels.levels(); ++level) {
        const int side = voxels.width() >> level;
        gl::TexSubImage3D(GL_TEXTURE_3D, level, 0, 0, 0, side, side, side, GL_RED_INTEGER, GL_UNSIGNED_INT,
                          base.data());
        if (level + 1 < voxels.levels()) base = mipOnCpu(base, side);
    }
}

Faces FrameInspector::faces() {
    renderer_.render({{Output::indirectLight}, camera_, LightSteps::one, nullptr, false});
    return readFaces(renderer_.directional()->voxels());
}

IrradianceByFace FrameInspector::irradiance(bool allBounces) {
    view(Output::indirectLight, allBounces);
    return readIrradiance(renderer_);
}

}  // namespace vct::test
