#include "image/radiance_file.h"

#include <stb_image.h>

#include <algorithm>
#include <climits>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/error.h"
#include "image/files.h"

namespace vct {
namespace {

// Checks a Radiance file by the rules that stb_image reads it by, and throws vct::Error if it is damaged.
// stb_image itself reads zeros beyond the end and loops forever on some damaged files.
class RadianceFile {
  public:
    explicit RadianceFile(const Bytes& bytes) : bytes_(bytes) {
        std::string line = nextLine();
        while (!(line = nextLine()).empty())
            if (line.rfind("FORMAT=", 0) == 0 && line != "FORMAT=32-bit_rle_rgbe")
                throw Error("its " + line + " is not 32-bit_rle_rgbe");
        line = nextLine();
        char rest = 0;
        if (std::sscanf(line.c_str(), "-Y %d +X %d %c", &height_, &width_, &rest) != 2 || width_ < 1 ||
            height_ < 1)
            throw Error("its size '" + line.substr(0, 40) + "' does not have the form -Y HEIGHT +X WIDTH");
        if (width_ > maxImageSide || height_ > maxImageSide)
            throw Error("its size is " + std::to_string(width_) + " x " + std::to_string(height_) +
                        " pixels, and the limit is " + std::to_string(maxImageSide) + " per side");
        if (!isRunLength())
            skip(std::size_t{4} * width_ * height_);
        else
            for (int y = 0; y < height_; ++y)
                skipRow();
    }

    int width() const { return width_; }
    int height() const { return height_; }

  private:
    std::string nextLine() {
        const auto end = std::find(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), bytes_.end(), '\n');
        if (end == bytes_.end()) throw Error("its header is incomplete");
        std::string line(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), end);
        at_ += line.size() + 1;
        return line;
    }
    void skip(std::size_t count) {
        if (bytes_.size() - at_ < count) throw Error("it is incomplete");
        at_ += count;
    }
    int next() {
        skip(1);
        return bytes_[at_ - 1];
    }
    bool isRunLength() const {
        return width_ >= 8 && width_ < 32768 && bytes_.size() - at_ >= 4 && bytes_[at_] == 2 &&
               bytes_[at_ + 1] == 2 && bytes_[at_ + 2] < 128;
    }
    // A row has four planes (R, G, B, exponent) of packets. A code above 128 is a run: one value, repeated
    // code - 128 times. A lower code is the number of single values that follow.
    void skipRow() {
        if (!isRunLength() || bytes_[at_ + 2] * 256 + bytes_[at_ + 3] != width_)
            throw Error(bytes_.size() - at_ < 4 ? "it is incomplete" : "a row of it is damaged");
        skip(4);
        for (int plane = 0; plane < 4; ++plane)
            for (int left = width_; left > 0;) {
                const int code = next();
                const int count = code > 128 ? code - 128 : code;
                if (count == 0 || count > left) throw Error("a row of it is damaged");
                skip(code > 128 ? 1 : static_cast<std::size_t>(count));
                left -= count;
            }
    }

    const Bytes& bytes_;
    std::size_t at_ = 0;
    int width_ = 0, height_ = 0;
};

Image decoded(const Bytes& bytes) {
    if (bytes.size() > INT_MAX) throw Error("it is larger than 2 GiB");
    const RadianceFile whole(bytes);
    requirePixelMemory(whole.width(), whole.height(),
                       3 * sizeof(float) * static_cast<std::size_t>(whole.width()) *
                           static_cast<std::size_t>(whole.height()));
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<float, void (*)(void*)> pixels(
        stbi_loadf_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width, &height, &channels, 3),
        stbi_image_free);
    if (!pixels) throw Error(stbi_failure_reason());
    Image image(width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = {pixels.get()[3 * i], pixels.get()[3 * i + 1], pixels.get()[3 * i + 2]};
    return image;
}

}  // namespace

bool isRadiance(const Bytes& bytes) {
    return bytes.size() > 2 && std::memcmp(bytes.data(), "#?", 2) == 0;
}

Image decodeRadiance(const std::string& path, const Bytes& bytes) {
    try {
        if (!isRadiance(bytes))
            throw Error(bytes.empty() ? "the file is empty" : "it is no Radiance picture");
        return decoded(bytes);
    } catch (const std::exception& error) {
        throw Error("cannot read the sky '" + path + "': " + error.what() +
                    "; make it again, as a Radiance or EXR picture that other programs can open");
    }
}

}  // namespace vct
