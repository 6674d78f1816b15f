// Writes PNG files by stb_image_write.
#include <stb_image_write.h>

#include "core/error.h"
#include "image/files.h"

namespace vct {
namespace {

void append(void* bytes, void* data, int size) {
    static_cast<std::string*>(bytes)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

}  // namespace

void checkWritable(const std::string& path, const Image& image) {
    const auto inRange = [](int side) { return side > 0 && side <= maxImageSide; };
    const std::string size = std::to_string(image.width) + " x " + std::to_string(image.height);
    if (!inRange(image.width) || !inRange(image.height)) {
        throw Error("cannot write picture '" + path + "': it is " + size + " pixels; choose 1 to " +
                    std::to_string(maxImageSide) + " pixels per side");
    }
    if (image.pixels.size() !=
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
        throw Error("cannot write picture '" + path + "': its size is " + size + ", but it holds " +
                    std::to_string(image.pixels.size()) + " pixels; this is a bug, please report it");
    }
}

void writePng(const std::string& path, const Image& image) {
    checkWritable(path, image);
    Bytes rgb;
    rgb.reserve(image.pixels.size() * 3);
    for (const glm::vec3& pixel : image.pixels) {
        for (int c = 0; c < 3; ++c) {
            rgb.push_back(static_cast<unsigned char>(srgbEncode(pixel[c]) * 255.0F + 0.5F));
        }
    }
    std::string file;
    if (stbi_write_png_to_func(append, &file, image.width, image.height, 3, rgb.data(), image.width * 3) ==
        0) {
        throw Error("cannot write picture '" + path +
                    "': PNG encoding ran out of memory; choose a smaller size");
    }
    replaceFile(path, file);
}

}  // namespace vct
