#include "engine/material_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "image/image.h"

namespace vct {

namespace {

GLenum glWrap(Texture::Wrap wrap) {
    switch (wrap) {
        case Texture::Wrap::clampToEdge:
            return GL_CLAMP_TO_EDGE;
        case Texture::Wrap::mirroredRepeat:
            return GL_MIRRORED_REPEAT;
        case Texture::Wrap::repeat:
            break;
    }
    return GL_REPEAT;
}

// The next mip level: half the size, at least one texel. A texel is the mean of the texels that it covers.
// Colours are averaged as linear light, numbers and alpha as they are.
std::vector<std::uint8_t> halved(const std::uint8_t* from, int fromWidth, int fromHeight, TextureOf of) {
    static const std::array<float, 256> lightOf = [] {
        std::array<float, 256> linearValues{};
        for (std::size_t code = 0; code < linearValues.size(); ++code)
            linearValues[code] = srgbDecode(static_cast<float>(code) / 255.0F);
        return linearValues;
    }();
    const auto value = [of](std::uint8_t code) {
        return of == TextureOf::colors ? lightOf[code] : static_cast<float>(code) / 255.0F;
    };
    const int width = std::max(fromWidth / 2, 1), height = std::max(fromHeight / 2, 1);
    const auto forEach = [](int at, int count, int fromCount, const auto& visit) {
        const float ratio = static_cast<float>(fromCount) / static_cast<float>(count);
        const float low = static_cast<float>(at) * ratio, high = low + ratio;
        for (int i = static_cast<int>(low); i < std::min(static_cast<int>(std::ceil(high)), fromCount); ++i)
            visit(i,
                  (std::min(static_cast<float>(i + 1), high) - std::max(static_cast<float>(i), low)) / ratio);
    };
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            glm::vec4 sum(0.0F);
            forEach(y, height, fromHeight, [&](int row, float rowShare) {
                forEach(x, width, fromWidth, [&](int column, float share) {
                    const std::uint8_t* texel =
                        from + (static_cast<std::size_t>(row) * fromWidth + column) * 4;
                    const float alpha = static_cast<float>(texel[3]) / 255.0F;
                    sum += rowShare * share *
                           glm::vec4(value(texel[0]), value(texel[1]), value(texel[2]), alpha);
                });
            });
            for (int c = 0; c < 4; ++c)
                rgba.push_back(static_cast<std::uint8_t>(
                    (c < 3 && of == TextureOf::colors ? srgbEncode(sum[c]) : sum[c]) * 255.0F + 0.5F));
        }
    return rgba;
}

}  // namespace

gl::Texture materialTexture(const Texture& source, TextureOf of) {
    const int levels = static_cast<int>(std::log2(std::max(source.width, source.height))) + 1;
    gl::Texture texture =
        gl::Texture::make2d("texture " + source.name, of == TextureOf::colors ? GL_SRGB8_ALPHA8 : GL_RGBA8,
                            source.width, source.height, levels);
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const auto upload = [](int level, int width, int height, const std::uint8_t* rgba) {
        gl::TexSubImage2D(GL_TEXTURE_2D, level, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    };
    upload(0, source.width, source.height, source.rgba.data());
    if (source.height <= source.width) {
        gl::GenerateMipmap(GL_TEXTURE_2D);
    } else {
        // glGenerateMipmap fails on PowerVR Rogue for textures higher than wide (PPSSPP,
        // PVR_GENMIPMAP_HEIGHT_GREATER).
        std::vector<std::uint8_t> mip;
        int width = source.width, height = source.height;
        for (int level = 1; level < levels; ++level) {
            mip = halved(level == 1 ? source.rgba.data() : mip.data(), width, height, of);
            width = std::max(width / 2, 1);
            height = std::max(height / 2, 1);
            upload(level, width, height, mip.data());
        }
    }
    texture.setFilter(GL_LINEAR_MIPMAP_LINEAR, source.linearFilter ? GL_LINEAR : GL_NEAREST);
    texture.setParameter(GL_TEXTURE_WRAP_S, glWrap(source.wrapS));
    texture.setParameter(GL_TEXTURE_WRAP_T, glWrap(source.wrapT));
    return texture;
}

}  // namespace vct
