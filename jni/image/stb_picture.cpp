#include "image/stb_picture.h"

#include <stb_image.h>
#include <zlib.h>

#include <algorithm>
#include <climits>
#include <cstring>
#include <memory>
#include <string>

namespace vct {
namespace {

constexpr unsigned char pngSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr unsigned char jpegSignature[] = {0xFF, 0xD8, 0xFF};

std::size_t bigEndian32(const unsigned char* p) {
    return std::size_t(p[0]) << 24 | std::size_t(p[1]) << 16 | std::size_t(p[2]) << 8 | std::size_t(p[3]);
}

// Resets stb_image's failure reason to the one for an empty picture, and returns it. Some failures of
// stb_image set no reason; without the reset it would report the reason of an earlier picture.
std::string stbiFailureReason() {
    int unused = 0;
    const unsigned char nothing = 0;
    stbi_info_from_memory(&nothing, 1, &unused, &unused, &unused);
    return stbi_failure_reason();
}

// stb_image's failure reason as printable text, or "" if it is none. It can begin with a damaged chunk's
// name, which may be any four bytes, and a zero ends it.
std::string failureReason() {
    std::string reason = stbi_failure_reason();
    if (reason.size() <= 4) return "";
    std::replace_if(reason.begin(), reason.end(), [](unsigned char c) { return c < 0x20 || c > 0x7E; }, '?');
    return reason;
}

}  // namespace

StbPicture::StbPicture(const unsigned char* bytes, std::size_t size) : bytes_(bytes), size_(size) {
    const auto startsWith = [&](const unsigned char* magic, std::size_t count) {
        return size >= count && std::memcmp(bytes, magic, count) == 0;
    };
    isPng_ = startsWith(pngSignature, sizeof pngSignature);
    // stb_image reads other formats too, but by its least tested code.
    if (!isPng_ && !startsWith(jpegSignature, sizeof jpegSignature))
        throw PictureError("it is neither PNG nor JPEG");
    if (size > INT_MAX) throw PictureError("it is larger than 2 GiB");
    if (isPng_) {
        readPngHeader();
        return;
    }
    int channels = 0;
    if (stbi_info_from_memory(bytes, static_cast<int>(size), &width_, &height_, &channels) == 0)
        throw PictureError("its header is damaged or of an unsupported kind");
    // Up to 16 bytes per pixel: the planes, the 16-bit coefficients of a progressive picture, the pixels, and
    // their copy.
    decodingBytes_ = std::size_t{16} * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
}

// Reads the IHDR chunk; sections 11.2.2 and 7.2 of the PNG specification (third edition).
void StbPicture::readPngHeader() {
    const unsigned char* const header = bytes_ + sizeof pngSignature;
    if (size_ < 33 || bigEndian32(header) != 13 || std::memcmp(header + 4, "IHDR", 4) != 0)
        throw PictureError("its header is damaged");
    const std::size_t width = bigEndian32(header + 8), height = bigEndian32(header + 12);
    if (width < 1 || height < 1 || width > INT_MAX || height > INT_MAX)
        throw PictureError("its header claims " + std::to_string(width) + " x " + std::to_string(height) +
                           " pixels");
    width_ = static_cast<int>(width);
    height_ = static_cast<int>(height);
    const unsigned depth = header[16], type = header[17];
    const std::size_t channels = type == 0 || type == 3 ? 1 : type == 4 ? 2 : type == 2 ? 3 : 4;
    // Each row begins with one byte for its filter. An interlaced picture has seven passes, each with its own
    // rows.
    const std::size_t rows = header[20] == 0 ? height : 2 * height + 7;
    const std::size_t rowBytes = (width * channels * std::min(depth, 16U) + 7) / 8;
    inflatedBytes_ = height * rowBytes + rows * (header[20] == 0 ? 1 : 2) + 64;
    const std::size_t unpacked = width * height * (depth == 16 ? 8 : 4) * (header[20] == 0 ? 1 : 2);
    // decode() copies the pixels into its result, after the inflated data is freed.
    decodingBytes_ = std::max(inflatedBytes_ + unpacked, width * height * 8);
}

// Deflate can pack a thousand bytes into one, and stb_image inflates all of the data whatever size the header
// gives. This inflates large files in small steps first, and throws when they hold too much.
void StbPicture::checkDeflatedSize() const {
    constexpr std::size_t harmless = std::size_t{16} << 20;
    if (size_ * 1032 <= inflatedBytes_ + harmless) return;
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) throw PictureError("there is not enough memory to decode it");
    const std::unique_ptr<z_stream, int (*)(z_stream*)> ended(&stream, inflateEnd);
    std::vector<unsigned char> window(std::size_t{1} << 18);
    std::size_t inflated = 0;
    for (std::size_t at = sizeof pngSignature; size_ - at >= 12;) {
        const std::size_t length = bigEndian32(bytes_ + at);
        if (length > size_ - at - 12) return;  // incomplete; stb_image reports it
        if (std::memcmp(bytes_ + at + 4, "IDAT", 4) == 0) {
            stream.next_in = const_cast<unsigned char*>(bytes_ + at + 8);
            stream.avail_in = static_cast<unsigned>(length);
            do {
                stream.next_out = window.data();
                stream.avail_out = static_cast<unsigned>(window.size());
                const int result = inflate(&stream, Z_NO_FLUSH);
                if (result == Z_BUF_ERROR) break;  // this chunk is used up
                if (result != Z_OK) return;        // the end, or damaged data that stb_image reports
                inflated += window.size() - stream.avail_out;
                if (inflated > inflatedBytes_ + harmless)
                    throw PictureError("it holds more data than its " + std::to_string(width_) + " x " +
                                       std::to_string(height_) + " pixels need");
            } while (stream.avail_out == 0);
        }
        at += 12 + length;
    }
}

std::vector<std::uint8_t> StbPicture::decode(int channels) const {
    // One byte of Deflate holds at most 1032 bytes, and one byte of a JPEG at most 512 pixels. A header that
    // claims more is wrong, so nothing is allocated for it.
    const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    const std::string extent = std::to_string(width_) + " x " + std::to_string(height_) + " pixels";
    if (pixels / 8 > size_ * 1032)  // a PNG pixel may be a single bit
        throw PictureError("its header claims " + extent + ", but the file has only " +
                           std::to_string(size_) + " bytes");
    if (isPng_) checkDeflatedSize();
    const std::string noReason = stbiFailureReason();
    int width = 0, height = 0, channelsOfFile = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> decoded(
        stbi_load_from_memory(bytes_, static_cast<int>(size_), &width, &height, &channelsOfFile, channels),
        stbi_image_free);
    if (decoded == nullptr) {
        const std::string reason = stbi_failure_reason() == noReason ? "" : failureReason();
        throw PictureError(reason.empty() ? "its data are damaged" : reason);
    }
    if (width != width_ || height != height_)
        throw PictureError("its size differs from the one in its header");
    return {decoded.get(), decoded.get() + pixels * static_cast<std::size_t>(channels)};
}

}  // namespace vct
