// Pictures in memory and on disk. Linear RGB float inside; sRGB only where a PNG is written.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace vct {

struct Image {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> pixels;  // linear RGB, row 0 at the top

    Image() = default;
    Image(int w, int h, glm::vec3 fill = glm::vec3(0.0F))
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}

    glm::vec3& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
    const glm::vec3& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

// IEC 61966-2-1 transfer function; clamps to [0, 1], NaN becomes 0.
float srgbEncode(float linear);
float srgbDecode(float encoded);

// 8-bit RGB PNG, sRGB-encoded. Written beside the target and then renamed; throws vct::Error on failure.
void writePng(const std::string& path, const Image& image);

// 32-bit float RGB OpenEXR, linear and unclamped. Written beside the target and then renamed.
void writeExr(const std::string& path, const Image& image);

// PNG (decoded to linear) or EXR, by content. Throws vct::Error naming the file and the cause.
Image readImage(const std::string& path);

// The pictures side by side on a white sheet in reading order, `columns` per row, each with its label below.
Image contactSheet(const std::vector<std::pair<std::string, Image>>& pictures, int columns);

}  // namespace vct
