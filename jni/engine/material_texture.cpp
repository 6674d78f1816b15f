#include "engine/material_texture.h"

#include <algorithm>
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

// A level as light, not as codes: alpha is in 0..1 either way.
struct Level {
    int width, height;
    std::vector<glm::vec4> texels;
};

Level decoded(const Texture& source) {
    Level level{source.width, source.height, {}};
    for (std::size_t i = 0; i < source.rgba.size(); i += 4) {
        glm::vec4 texel;
        for (int c = 0; c < 4; ++c) {
            const float code = static_cast<float>(source.rgba[i + static_cast<std::size_t>(c)]) / 255.0F;
            texel[c] = c < 3 ? srgbDecode(code) : code;
        }
        level.texels.push_back(texel);
    }
    return level;
}

std::vector<std::uint8_t> encoded(const Level& level) {
    std::vector<std::uint8_t> rgba;
    for (const glm::vec4& texel : level.texels)
        for (int c = 0; c < 4; ++c)
            rgba.push_back(
                static_cast<std::uint8_t>((c < 3 ? srgbEncode(texel[c]) : texel[c]) * 255.0F + 0.5F));
    return rgba;
}

// Each texel the mean of those that it lies over.
Level halved(const Level& from) {
    Level to{std::max(from.width / 2, 1), std::max(from.height / 2, 1), {}};
    const auto forEach = [](int at, int count, int fromCount, const auto& visit) {
        const float ratio = static_cast<float>(fromCount) / static_cast<float>(count);
        const float low = static_cast<float>(at) * ratio, high = low + ratio;
        for (int i = static_cast<int>(low); i < std::min(static_cast<int>(std::ceil(high)), fromCount); ++i)
            visit(i,
                  (std::min(static_cast<float>(i + 1), high) - std::max(static_cast<float>(i), low)) / ratio);
    };
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x) {
            glm::vec4 sum(0.0F);
            forEach(y, to.height, from.height, [&](int row, float rowShare) {
                forEach(x, to.width, from.width, [&](int column, float share) {
                    sum +=
                        rowShare * share * from.texels[static_cast<std::size_t>(row) * from.width + column];
                });
            });
            to.texels.push_back(sum);
        }
    return to;
}

}  // namespace

gl::Texture materialTexture(const Texture& source) {
    const int levels = static_cast<int>(std::log2(std::max(source.width, source.height))) + 1;
    gl::Texture texture =
        gl::Texture::make2d("texture " + source.name, GL_SRGB8_ALPHA8, source.width, source.height, levels);
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const auto upload = [](int level, int width, int height, const std::vector<std::uint8_t>& rgba) {
        gl::TexSubImage2D(GL_TEXTURE_2D, level, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    };
    upload(0, source.width, source.height, source.rgba);
    if (source.height <= source.width) {
        gl::GenerateMipmap(GL_TEXTURE_2D);
    } else {
        // A PowerVR Rogue makes none where the height is the greater: PPSSPP, PVR_GENMIPMAP_HEIGHT_GREATER.
        Level mip = decoded(source);
        for (int level = 1; level < levels; ++level) {
            mip = halved(mip);
            upload(level, mip.width, mip.height, encoded(mip));
        }
    }
    texture.setFilter(GL_LINEAR_MIPMAP_LINEAR, source.linearFilter ? GL_LINEAR : GL_NEAREST);
    texture.setParameter(GL_TEXTURE_WRAP_S, glWrap(source.wrapS));
    texture.setParameter(GL_TEXTURE_WRAP_T, glWrap(source.wrapT));
    return texture;
}

}  // namespace vct
