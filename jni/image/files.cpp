#include "image/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/error.h"

namespace vct {
namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

bool startsWith(const Bytes& bytes, std::initializer_list<unsigned char> magic) {
    return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.begin(), magic.size()) == 0;
}

}  // namespace

Bytes readImageFile(const std::string& path) {
    errno = 0;
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file) {
        throw Error("cannot open picture '" + path + "': " + std::strerror(errno) + "; check the path");
    }
    Bytes bytes;
    unsigned char block[65536];
    while (const std::size_t count = std::fread(block, 1, sizeof block, file.get())) {
        bytes.insert(bytes.end(), block, block + count);
    }
    if (std::ferror(file.get())) {
        throw Error("cannot read picture '" + path + "': " + std::strerror(errno) +
                    "; give the path of a PNG or EXR file");
    }
    return bytes;
}

ImageFormat imageFormat(const std::string& path, const Bytes& bytes) {
    if (startsWith(bytes, {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'})) return ImageFormat::png;
    if (startsWith(bytes, {0x76, 0x2F, 0x31, 0x01})) return ImageFormat::exr;
    throw Error("cannot read picture '" + path +
                "': " + (bytes.empty() ? "the file is empty" : "it is neither a PNG nor an EXR") +
                "; make the picture again as one of the two");
}

void checkWritable(const std::string& path, const Image& image) {
    const auto inRange = [](int side) { return side > 0 && side <= maxImageSide; };
    const std::string size = std::to_string(image.width) + " x " + std::to_string(image.height);
    if (!inRange(image.width) || !inRange(image.height)) {
        throw Error("cannot write picture '" + path + "': it is " + size +
                    " pixels; choose a size from 1 to " + std::to_string(maxImageSide) + " a side");
    }
    if (image.pixels.size() !=
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
        throw Error("cannot write picture '" + path + "': it says " + size + " but holds " +
                    std::to_string(image.pixels.size()) + " pixels; this is a bug, please report it");
    }
}

}  // namespace vct
