#include "gl/read_back.h"

#include <algorithm>

namespace vct {

Image readImage(const gl::Texture& texture, float scale) {
    const gl::Framebuffer framebuffer("read back", {&texture}, nullptr);
    framebuffer.bind();
    gl::ReadBuffer(GL_COLOR_ATTACHMENT0);
    std::vector<float> rgba(static_cast<std::size_t>(texture.width()) * texture.height() * 4);
    gl::PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl::ReadPixels(0, 0, texture.width(), texture.height(), GL_RGBA, GL_FLOAT, rgba.data());
    Image image(texture.width(), texture.height());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const float* p = &rgba[(static_cast<std::size_t>(image.height - 1 - y) * image.width + x) * 4];
            image.at(x, y) = scale * glm::vec3(p[0], p[1], p[2]);
        }
    return image;
}

std::vector<std::uint32_t> readVoxels(const gl::Texture& voxels, int level) {
    const int side = std::max(voxels.width() >> level, 1);
    const std::size_t slice = static_cast<std::size_t>(side) * side;
    const gl::Framebuffer framebuffer("read back voxels", 1, 1);
    framebuffer.bind();
    gl::ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl::MemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
    // RGBA_INTEGER is the only layout of unsigned integers that every ES driver can read.
    std::vector<std::uint32_t> rgba(slice * 4);
    std::vector<std::uint32_t> words(slice * side);
    for (int z = 0; z < side; ++z) {
        gl::FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, voxels.name(), level, z);
        gl::ReadPixels(0, 0, side, side, GL_RGBA_INTEGER, GL_UNSIGNED_INT, rgba.data());
        for (std::size_t i = 0; i < slice; ++i)
            words[z * slice + i] = rgba[i * 4];
    }
    return words;
}

}  // namespace vct
