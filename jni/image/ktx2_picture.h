// KTX2 by libktx, with the memory that decoding takes known before, as StbPicture has it.
#pragma once

#include "image/stb_picture.h"

namespace vct {

// Whether a picture that begins with these bytes is KTX2.
bool isKtx2(const unsigned char* bytes, std::size_t size);

// The header of a picture, read from bytes that outlive it. It throws PictureErrors, always where the build
// lacks the library.
class Ktx2Picture {
  public:
    Ktx2Picture(const unsigned char* bytes, std::size_t size);

    int width() const { return width_; }
    int height() const { return height_; }
    // The most that decode() has allocated at once, its result included.
    std::size_t decodingBytes() const;
    // Rows from the top of four 8-bit values per pixel, RGBA; of Basis Universal's two codecs, and of plain
    // 8-bit RGB and RGBA.
    std::vector<std::uint8_t> decode() const;

  private:
    // A build that lacks the library reads neither.
    [[maybe_unused]] const unsigned char* bytes_;
    [[maybe_unused]] std::size_t size_;
    int width_ = 0, height_ = 0;
    std::size_t inflatedBytes_ = 0;  // of all levels
};

}  // namespace vct
