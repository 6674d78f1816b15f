#include "image/webp_picture.h"

#ifdef VCT_HAS_WEBP
#include <webp/decode.h>
#endif

#include <cstring>

namespace vct {

// RFC 9649 section 2.4.
bool isWebp(const unsigned char* bytes, std::size_t size) {
    return size >= 12 && std::memcmp(bytes, "RIFF", 4) == 0 && std::memcmp(bytes + 8, "WEBP", 4) == 0;
}

// Lossless decoding holds the pixels as 32-bit words besides its result; lossy decoding holds only some rows
// of planes.
std::size_t WebpPicture::decodingBytes() const {
    return std::size_t{12} * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
}

#ifdef VCT_HAS_WEBP

const bool readsWebp = true;

WebpPicture::WebpPicture(const unsigned char* bytes, std::size_t size) : bytes_(bytes), size_(size) {
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(bytes, size, &features) != VP8_STATUS_OK) throw PictureError("its header is damaged");
    if (features.has_animation != 0) throw PictureError("it is an animation");
    width_ = features.width;
    height_ = features.height;
}

std::vector<std::uint8_t> WebpPicture::decode() const {
    const std::size_t rowBytes = std::size_t{4} * static_cast<std::size_t>(width_);
    std::vector<std::uint8_t> rgba(rowBytes * static_cast<std::size_t>(height_));
    if (WebPDecodeRGBAInto(bytes_, size_, rgba.data(), rgba.size(), static_cast<int>(rowBytes)) == nullptr)
        throw PictureError("its data are damaged");
    return rgba;
}

#else

const bool readsWebp = false;

WebpPicture::WebpPicture(const unsigned char* bytes, std::size_t size) : bytes_(bytes), size_(size) {
    throw PictureError(
        "it is WebP, and this build cannot read WebP; install libwebp-dev and build with the CMake option "
        "VCT_WEBP=ON");
}

std::vector<std::uint8_t> WebpPicture::decode() const {
    return {};
}

#endif

}  // namespace vct
