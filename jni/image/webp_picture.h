// Decodes WebP by libwebp. As with StbPicture, the caller can ask how much memory decoding takes.
#pragma once

#include "image/stb_picture.h"

namespace vct {

// Returns true if a picture that begins with these bytes is WebP.
bool isWebp(const unsigned char* bytes, std::size_t size);

// True if this build has libwebp.
extern const bool readsWebp;

// A WebP picture. The constructor reads only the header; decode() reads the pixels. The bytes must outlive
// the object. Errors are PictureErrors; a build without libwebp throws one for every picture.
class WebpPicture {
  public:
    WebpPicture(const unsigned char* bytes, std::size_t size);

    int width() const { return width_; }
    int height() const { return height_; }
    // Peak memory of decode(), including its result.
    std::size_t decodingBytes() const;
    // RGBA with 8 bits per value, rows from the top.
    std::vector<std::uint8_t> decode() const;

  private:
    // Unused in a build without libwebp.
    [[maybe_unused]] const unsigned char* bytes_;
    [[maybe_unused]] std::size_t size_;
    int width_ = 0, height_ = 0;
};

}  // namespace vct
