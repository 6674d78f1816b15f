// PNG and JPEG by stb_image, with the memory that decoding takes known before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace vct {

// Holds the cause alone: the caller knows the file and the remedy.
struct PictureError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The header of a picture, read from bytes that outlive it. It throws PictureErrors.
class StbPicture {
  public:
    StbPicture(const unsigned char* bytes, std::size_t size);

    int width() const { return width_; }
    int height() const { return height_; }
    // The most that decode() has allocated at once, its result included.
    std::size_t decodingBytes() const { return decodingBytes_; }
    // Rows from the top of so many 8-bit values per pixel, which are 3 (RGB) or 4 (RGBA).
    std::vector<std::uint8_t> decode(int channels) const;

  private:
    void readPngHeader();
    void checkDeflatedSize() const;

    const unsigned char* bytes_;
    std::size_t size_;
    int width_ = 0, height_ = 0;
    bool isPng_ = false;
    std::size_t inflatedBytes_ = 0;  // of a PNG, at most
    std::size_t decodingBytes_ = 0;
};

}  // namespace vct
