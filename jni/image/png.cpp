#include <stb_image.h>
#include <stb_image_write.h>

#include <array>
#include <climits>
#include <cstdint>
#include <cstring>
#include <memory>

#include "core/error.h"
#include "image/files.h"

namespace vct {
namespace {

void append(void* bytes, void* data, int size) {
    const auto* first = static_cast<const unsigned char*>(data);
    static_cast<Bytes*>(bytes)->insert(static_cast<Bytes*>(bytes)->end(), first, first + size);
}

std::uint32_t bigEndian(const unsigned char* p) {
    return std::uint32_t(p[0]) << 24 | std::uint32_t(p[1]) << 16 | std::uint32_t(p[2]) << 8 |
           std::uint32_t(p[3]);
}

std::uint32_t crc32(const unsigned char* first,
                    const unsigned char* last) {  // of the PNG specification, annex D
    static const std::array<std::uint32_t, 256> table = [] {
        std::array<std::uint32_t, 256> result{};
        for (std::uint32_t i = 0; i < 256; ++i) {
            std::uint32_t c = i;
            for (int k = 0; k < 8; ++k)
                c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1) : c >> 1;
            result[i] = c;
        }
        return result;
    }();
    std::uint32_t crc = 0xFFFFFFFFU;
    for (; first != last; ++first)
        crc = table[(crc ^ *first) & 0xFFU] ^ (crc >> 8);
    return ~crc;
}

// stb ignores checksums and a missing end, so it would take some damaged files for pictures.
bool chunksAreWhole(const Bytes& bytes) {
    std::size_t at = 8;  // after the signature
    while (bytes.size() - at >= 12) {
        const unsigned char* chunk = bytes.data() + at;  // length, type, data, checksum
        const std::size_t length = bigEndian(chunk);
        if (bytes.size() - at - 12 < length) return false;
        if (crc32(chunk + 4, chunk + 8 + length) != bigEndian(chunk + 8 + length)) return false;
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

void writePng(const std::string& path, const Image& image) {
    checkWritable(path, image);
    Bytes rgb;
    rgb.reserve(image.pixels.size() * 3);
    for (const glm::vec3& pixel : image.pixels) {
        for (int c = 0; c < 3; ++c) {
            rgb.push_back(static_cast<unsigned char>(srgbEncode(pixel[c]) * 255.0F + 0.5F));
        }
    }
    Bytes file;
    if (stbi_write_png_to_func(append, &file, image.width, image.height, 3, rgb.data(), image.width * 3) ==
        0) {
        throw Error("cannot write picture '" + path +
                    "': PNG encoding ran out of memory; choose a smaller size");
    }
    replaceFile(path, file);
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

}  // namespace vct
