// Pictures in memory and on disk. They are linear RGB float in memory and sRGB only in PNG files.
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

// The sRGB transfer function (IEC 61966-2-1) and its inverse. Both clamp to [0, 1]; NaN becomes 0.
float srgbEncode(float linear);
float srgbDecode(float encoded);

// Writes an 8-bit RGB PNG, sRGB-encoded, atomically (replaceFile()). Throws vct::Error on failure.
void writePng(const std::string& path, const Image& image);

// Writes a 32-bit float RGB EXR, linear and unclamped, atomically (replaceFile()). Throws vct::Error on
// failure.
void writeExr(const std::string& path, const Image& image);

// Reads a PNG (decoded to linear values) or an EXR; the content decides which. Throws vct::Error naming the
// file, the cause and the remedy.
Image readImage(const std::string& path);

// Puts the pictures on a white sheet in reading order, `columns` per row, each with its label below.
Image contactSheet(const std::vector<std::pair<std::string, Image>>& pictures, int columns);

}  // namespace vct
