#include <stb_image.h>
#include <zlib.h>

#include <array>
#include <climits>
#include <cstring>
#include <memory>

#include "core/error.h"
#include "image/files.h"
#include "scene/gltf.h"

namespace vct {
namespace {

bool startsWith(const Bytes& bytes, std::initializer_list<unsigned char> magic) {
    return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.begin(), magic.size()) == 0;
}

std::size_t bigEndian(const unsigned char* p) {
    return std::size_t(p[0]) << 24 | std::size_t(p[1]) << 16 | std::size_t(p[2]) << 8 | std::size_t(p[3]);
}

// stb ignores checksums and a missing end, so it would take some damaged files for pictures.
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
                "; make the picture again as one of the two");
}

Image decodePng(const std::string& path, const Bytes& bytes) {
    const auto fail = [&](const std::string& cause) {
        throw Error("cannot read PNG '" + path + "': " + cause +
                    "; the file is damaged or too large, make it again");
    };
    if (bytes.size() > INT_MAX) fail("it is larger than 2 GiB");
    if (!chunksAreWhole(bytes)) fail("a part is missing or its checksum is wrong");
    const int size = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    const auto reason = [] {
        const char* text = stbi_failure_reason();
        return std::string(text != nullptr ? text : "unknown cause");
    };
    // The size first: a few bytes can ask for an enormous picture.
    if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0) fail(reason());
    if (width > maxImageSide || height > maxImageSide) {
        fail("it is " + std::to_string(width) + " x " + std::to_string(height) + ", above " +
             std::to_string(maxImageSide) + " a side");
    }
    // 16-bit PNGs are reduced to 8 bits here.
    const std::unique_ptr<stbi_uc, void (*)(void*)> rgb(
        stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 3), stbi_image_free);
    if (!rgb) fail(reason());

    static const std::array<float, 256> linear = decodeTable();
    Image image(width, height);
    const stbi_uc* value = rgb.get();
    for (glm::vec3& pixel : image.pixels) {
        for (int c = 0; c < 3; ++c)
            pixel[c] = linear[*value++];
    }
    return image;
}

Image readImage(const std::string& path) {
    const Bytes bytes = readFileFromDisk(path);
    return imageFormat(path, bytes) == ImageFormat::png ? decodePng(path, bytes) : decodeExr(path, bytes);
}

}  // namespace vct
