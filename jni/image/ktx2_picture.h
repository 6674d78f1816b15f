// Decodes KTX2 by libktx. As with StbPicture, the caller can ask how much memory decoding takes.
#pragma once

#include "image/stb_picture.h"

namespace vct {

// Returns true if a picture that begins with these bytes is KTX2.
bool isKtx2(const unsigned char* bytes, std::size_t size);

// A KTX2 picture. The constructor reads only the header; decode() reads the pixels. The bytes must outlive
// the object. Errors are PictureErrors; a build without libktx throws one for every picture.
class Ktx2Picture {
  public:
    Ktx2Picture(const unsigned char* bytes, std::size_t size);

    int width() const { return width_; }
    int height() const { return height_; }
    // Peak memory of decode(), including its result.
    std::size_t decodingBytes() const;
    // RGBA with 8 bits per value, rows from the top. Supports both codecs of Basis Universal and plain 8-bit
    // RGB and RGBA.
    std::vector<std::uint8_t> decode() const;

  private:
    // Unused in a build without libktx.
    [[maybe_unused]] const unsigned char* bytes_;
    [[maybe_unused]] std::size_t size_;
    int width_ = 0, height_ = 0;
    std::size_t inflatedBytes_ = 0;  // all mip levels, as stored and as decompressed
};

}  // namespace vct
