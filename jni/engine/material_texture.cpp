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

struct Level {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

// The next mip level: half the size, at least one texel. A texel is the mean of the texels that it covers.
// Colours are averaged as linear light, numbers and alpha as they are. The colours of a mask count by their
// alpha, because holes have no colour.
Level halved(const Level& from, TextureOf of, bool isMask) {
    static const std::array<float, 256> lightOf = [] {
        std::array<float, 256> linearValues{};
        for (std::size_t code = 0; code < linearValues.size(); ++code)
            linearValues[code] = srgbDecode(static_cast<float>(code) / 255.0F);
        return linearValues;
    }();
    const auto value = [of](std::uint8_t code) {
        return of == TextureOf::colors ? lightOf[code] : static_cast<float>(code) / 255.0F;
    };
    Level to{std::max(from.width / 2, 1), std::max(from.height / 2, 1), {}};
    const auto forEach = [](int at, int count, int fromCount, const auto& visit) {
        const float ratio = static_cast<float>(fromCount) / static_cast<float>(count);
        const float low = static_cast<float>(at) * ratio, high = low + ratio;
        for (int i = static_cast<int>(low); i < std::min(static_cast<int>(std::ceil(high)), fromCount); ++i)
            visit(i,
                  (std::min(static_cast<float>(i + 1), high) - std::max(static_cast<float>(i), low)) / ratio);
    };
    to.rgba.reserve(static_cast<std::size_t>(to.width) * to.height * 4);
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x) {
            glm::vec4 sum(0.0F);
            float weights = 0.0F;
            forEach(y, to.height, from.height, [&](int row, float rowShare) {
                forEach(x, to.width, from.width, [&](int column, float share) {
                    const std::uint8_t* texel =
                        &from.rgba[(static_cast<std::size_t>(row) * from.width + column) * 4];
                    const float alpha = static_cast<float>(texel[3]) / 255.0F;
                    const float weight = rowShare * share * (isMask ? std::max(alpha, 1e-4F) : 1.0F);
                    sum += glm::vec4(weight * glm::vec3(value(texel[0]), value(texel[1]), value(texel[2])),
                                     rowShare * share * alpha);
                    weights += weight;
                });
            });
            for (int c = 0; c < 4; ++c) {
                const float mean = c < 3 ? sum[c] / weights : sum[c];
                to.rgba.push_back(static_cast<std::uint8_t>(
                    (c < 3 && of == TextureOf::colors ? srgbEncode(mean) : mean) * 255.0F + 0.5F));
            }
        }
    return to;
}

// Alpha (0 to 255) at points that are spread evenly over a level, as a linear filter returns it between
// texels.
std::vector<float> alphaSamples(const Level& level) {
    const auto perTexel = [](int size) { return std::max(256 / size, 1); };
    const int columns = level.width * perTexel(level.width), rows = level.height * perTexel(level.height);
    const auto alpha = [&](int x, int y) {
        x = std::clamp(x, 0, level.width - 1);
        y = std::clamp(y, 0, level.height - 1);
        return static_cast<float>(level.rgba[(static_cast<std::size_t>(y) * level.width + x) * 4 + 3]);
    };
    std::vector<float> samples;
    samples.reserve(static_cast<std::size_t>(columns) * rows);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const float x = (column + 0.5F) * level.width / columns - 0.5F;
            const float y = (row + 0.5F) * level.height / rows - 0.5F;
            const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
            samples.push_back(glm::mix(glm::mix(alpha(left, top), alpha(left + 1, top), x - left),
                                       glm::mix(alpha(left, top + 1), alpha(left + 1, top + 1), x - left),
                                       y - top));
        }
    return samples;
}

double shareAtLeast(const std::vector<float>& samples, float threshold) {
    const auto count = std::count_if(samples.begin(), samples.end(),
                                     [threshold](float alpha) { return alpha >= threshold; });
    return static_cast<double>(count) / static_cast<double>(samples.size());
}

// Changes alpha linearly, so that `share` of the level is at least `threshold` (0 to 255). A linear change
// keeps its effect through the linear filter. Returns false if no change does so.
bool keepCoverage(Level& level, double share, float threshold) {
    std::vector<float> samples = alphaSamples(level);
    const auto [lowest, highest] = std::minmax_element(samples.begin(), samples.end());
    const float low = *lowest, high = *highest;
    const auto place =
        static_cast<std::ptrdiff_t>((1.0 - share) * static_cast<double>(samples.size() - 1) + 0.5);
    std::nth_element(samples.begin(), samples.begin() + place, samples.end());
    const float at = samples[static_cast<std::size_t>(place)];
    const float scale = std::min({1.0F, at > low ? threshold / (at - low) : 1.0F,
                                  high > at ? (255.0F - threshold) / (high - at) : 1.0F});
    for (std::size_t i = 3; i < level.rgba.size(); i += 4)
        level.rgba[i] = static_cast<std::uint8_t>(
            std::clamp(threshold + scale * (static_cast<float>(level.rgba[i]) - at), 0.0F, 255.0F) + 0.5F);
    const double tolerance = 0.02;
    return std::abs(shareAtLeast(alphaSamples(level), threshold) - share) <= tolerance;
}

}  // namespace

gl::Texture materialTexture(const Texture& source, TextureOf of, std::optional<float> holesBelow) {
    const int levels = static_cast<int>(std::log2(std::max(source.width, source.height))) + 1;
    gl::Texture texture =
        gl::Texture::make2d("texture " + source.name, of == TextureOf::colors ? GL_SRGB8_ALPHA8 : GL_RGBA8,
                            source.width, source.height, levels);
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const auto upload = [](int level, int width, int height, const std::uint8_t* rgba) {
        gl::TexSubImage2D(GL_TEXTURE_2D, level, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    };
    upload(0, source.width, source.height, source.rgba.data());
    if (source.height <= source.width && !holesBelow) {
        gl::GenerateMipmap(GL_TEXTURE_2D);
    } else {
        // glGenerateMipmap fails on PowerVR Rogue for textures higher than wide (PPSSPP,
        // PVR_GENMIPMAP_HEIGHT_GREATER).
        Level mip{source.width, source.height, {source.rgba.data(), source.rgba.data() + source.rgba.size()}};
        const float threshold = 255.0F * holesBelow.value_or(0.0F);
        const double share = holesBelow ? shareAtLeast(alphaSamples(mip), threshold) : 1.0;
        const bool hasHoles = share > 0.0 && share < 1.0;
        for (int level = 1; level < levels; ++level) {
            mip = halved(mip, of, hasHoles);
            Level uploaded = mip;
            if (hasHoles && !keepCoverage(uploaded, share, threshold)) {
                texture.setParameter(GL_TEXTURE_MAX_LEVEL, level - 1);
                break;
            }
            upload(level, uploaded.width, uploaded.height, uploaded.rgba.data());
        }
    }
    texture.setFilter(GL_LINEAR_MIPMAP_LINEAR, source.linearFilter ? GL_LINEAR : GL_NEAREST);
    texture.setParameter(GL_TEXTURE_WRAP_S, glWrap(source.wrapS));
    texture.setParameter(GL_TEXTURE_WRAP_T, glWrap(source.wrapT));
    return texture;
}

}  // namespace vct
