// Reads PNG files, and recognizes the format of a picture file.
#include <zlib.h>

#include <array>
#include <cstring>

#include "core/error.h"
#include "image/files.h"
#include "image/stb_picture.h"
#include "scene/gltf.h"

namespace vct {
namespace {

bool startsWith(const Bytes& bytes, std::initializer_list<unsigned char> magic) {
    return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.begin(), magic.size()) == 0;
}

std::size_t bigEndian(const unsigned char* p) {
    return std::size_t(p[0]) << 24 | std::size_t(p[1]) << 16 | std::size_t(p[2]) << 8 | std::size_t(p[3]);
}

// Checks what stb_image ignores and would therefore accept in a damaged file: checksums and a missing end.
bool chunksAreWhole(const Bytes& bytes) {
    std::size_t at = 8;  // after the signature
    while (bytes.size() - at >= 12) {
        const unsigned char* chunk = bytes.data() + at;  // length, type, data, checksum
        const std::size_t length = bigEndian(chunk);
        if (bytes.size() - at - 12 < length) return false;
        if (crc32_z(0, chunk + 4, 4 + length) != bigEndian(chunk + 8 + length)) return false;
        if (std::memcmp(chunk + 4, "IEND", 4) == 0) return true;
        at += 12 + length;
    }
    return false;
}

std::array<float, 256> decodeTable() {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = srgbDecode(static_cast<float>(i) / 255.0F);
    return table;
}

}  // namespace

ImageFormat imageFormat(const std::string& path, const Bytes& bytes) {
    if (startsWith(bytes, {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'})) return ImageFormat::png;
    if (startsWith(bytes, {0x76, 0x2F, 0x31, 0x01})) return ImageFormat::exr;
    throw Error("cannot read picture '" + path +
                "': " + (bytes.empty() ? "the file is empty" : "it is neither a PNG nor an EXR") +
                "; save the picture in one of these formats");
}

Image decodePng(const std::string& path, const Bytes& bytes) {
    const auto fail = [&](const std::string& cause) {
        throw Error("cannot read PNG '" + path + "': " + cause +
                    "; write the file again, or with fewer pixels");
    };
    if (!chunksAreWhole(bytes)) fail("a part is missing or its checksum is wrong");
    try {
        const StbPicture png(bytes.data(), bytes.size());
        if (png.width() > maxImageSide || png.height() > maxImageSide) {
            fail("its size is " + std::to_string(png.width()) + " x " + std::to_string(png.height()) +
                 " pixels, and the limit is " + std::to_string(maxImageSide) + " per side");
        }
        requirePixelMemory(png.width(), png.height(), png.decodingBytes());
        // decode() reduces 16-bit PNGs to 8 bits.
        const std::vector<std::uint8_t> rgb = png.decode(3);
        static const std::array<float, 256> linear = decodeTable();
        Image image(png.width(), png.height());
        const std::uint8_t* value = rgb.data();
        for (glm::vec3& pixel : image.pixels) {
            for (int c = 0; c < 3; ++c)
                pixel[c] = linear[*value++];
        }
        return image;
    } catch (const PictureError& error) {
        fail(error.what());
    }
    return {};
}

Image readImage(const std::string& path) {
    const Bytes bytes = readFileFromDisk(path);
    return imageFormat(path, bytes) == ImageFormat::png ? decodePng(path, bytes) : decodeExr(path, bytes);
}

}  // namespace vct
