// Decodes PNG and JPEG by stb_image. The caller can ask how much memory decoding takes before it starts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace vct {

// An error whose message is only the cause; the caller adds the file and the remedy.
struct PictureError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A PNG or JPEG picture. The constructor reads only the header; decode() reads the pixels. The bytes must
// outlive the object. Errors are PictureErrors.
class StbPicture {
  public:
    StbPicture(const unsigned char* bytes, std::size_t size);

    int width() const { return width_; }
    int height() const { return height_; }
    // Peak memory of decode(), including its result.
    std::size_t decodingBytes() const { return decodingBytes_; }
    // RGB (3 channels) or RGBA (4) with 8 bits per value, rows from the top.
    std::vector<std::uint8_t> decode(int channels) const;

  private:
    void readPngHeader();
    void checkDeflatedSize() const;

    const unsigned char* bytes_;
    std::size_t size_;
    int width_ = 0, height_ = 0;
    bool isPng_ = false;
    std::size_t inflatedBytes_ = 0;  // upper bound for a PNG's decompressed data
    std::size_t decodingBytes_ = 0;
};

}  // namespace vct
