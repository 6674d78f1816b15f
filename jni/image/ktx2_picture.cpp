#include "image/ktx2_picture.h"

#ifdef VCT_HAS_KTX
#include <ktx.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

#include <cerrno>
#include <cstring>
#include <string>

namespace vct {

// KTX file format 2.0, section 3.1.
bool isKtx2(const unsigned char* bytes, std::size_t size) {
    return size >= 12 && std::memcmp(bytes, "\xABKTX 20\xBB\r\n\x1A\n", 12) == 0;
}

// libktx holds the file's mip levels and those of the transcoded copy, which take 4/3 of its first level (5.3
// bytes per pixel). The result (4 bytes per pixel) exists twice: shared with the decoding process, and as a
// vector.
std::size_t Ktx2Picture::decodingBytes() const {
    const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    return inflatedBytes_ + 14 * pixels;
}

#ifdef VCT_HAS_KTX

namespace {

constexpr std::size_t headerBytes = 80, levelBytes = 24;  // sections 3 and 3.9
constexpr std::uint64_t maxInflatedBytes = std::uint64_t{1} << 40;

std::uint64_t littleEndian(const unsigned char* bytes, int count) {
    std::uint64_t value = 0;
    for (int i = count - 1; i >= 0; --i)
        value = value << 8 | bytes[i];
    return value;
}

}  // namespace

// Checks the header before libktx sees it, because libktx allocates whatever the header asks for.
Ktx2Picture::Ktx2Picture(const unsigned char* bytes, std::size_t size) : bytes_(bytes), size_(size) {
    const auto word = [&](std::size_t at) { return littleEndian(bytes + at, 4); };
    if (size < headerBytes) throw PictureError("its header is damaged");
    const std::uint64_t width = word(20), height = word(24), levels = word(40);
    if (width == 0 || height == 0 || width > INT32_MAX || height > INT32_MAX || levels > 32 ||
        size < headerBytes + levels * levelBytes)
        throw PictureError("its header is damaged");
    // The lengths of the parts besides the levels; libktx does not check them.
    if (word(52) > size || word(60) > size || littleEndian(bytes + 72, 8) > size)
        throw PictureError("its header is damaged");
    if (word(28) != 0 || word(32) > 1 || word(36) != 1)  // depth, layers, faces
        throw PictureError("it is not a single two-dimensional picture");
    width_ = static_cast<int>(width);
    height_ = static_cast<int>(height);
    for (std::size_t level = 0; level < levels; ++level) {
        const unsigned char* const entry = bytes + headerBytes + level * levelBytes;
        const std::uint64_t stored = littleEndian(entry + 8, 8), inflated = littleEndian(entry + 16, 8);
        if (stored > size || inflated > maxInflatedBytes) throw PictureError("its header is damaged");
        inflatedBytes_ += static_cast<std::size_t>(stored + inflated);
    }
}

namespace {

// Decodes the first mip level into `rgba`, which has four values for each of `pixels` pixels.
void decodeTo(std::uint8_t* rgba, std::size_t pixels, const unsigned char* bytes, std::size_t size) {
    const auto check = [](KTX_error_code code) {
        if (code != KTX_SUCCESS) throw PictureError(std::string("libktx finds: ") + ktxErrorString(code));
    };
    ktxTexture2* texture = nullptr;  // never destroyed: the process ends after decoding
    check(ktxTexture2_CreateFromMemory(bytes, size, KTX_TEXTURE_CREATE_LOAD_IMAGE_DATA_BIT, &texture));
    if (ktxTexture2_NeedsTranscoding(texture)) check(ktxTexture2_TranscodeBasis(texture, KTX_TTF_RGBA32, 0));

    // Vulkan's numbers: 23 and 29 are R8G8B8 (UNORM and SRGB), 37 and 43 are R8G8B8A8. The difference between
    // UNORM and SRGB does not matter: glTF defines the encoding by how the texture is used.
    const bool withoutAlpha = texture->vkFormat == 23 || texture->vkFormat == 29;
    if (!withoutAlpha && texture->vkFormat != 37 && texture->vkFormat != 43)
        throw PictureError("its pixels have VkFormat " + std::to_string(texture->vkFormat) +
                           ", and only Basis Universal and 8-bit RGB and RGBA are supported");
    const std::size_t channels = withoutAlpha ? 3 : 4;
    ktx_size_t offset = 0;
    check(ktxTexture_GetImageOffset(ktxTexture(texture), 0, 0, 0, &offset));
    if (offset > texture->dataSize || texture->dataSize - offset < pixels * channels)
        throw PictureError("its first mip level is incomplete");
    const std::uint8_t* source = texture->pData + offset;
    for (std::size_t i = 0; i < pixels; ++i, source += channels, rgba += 4) {
        rgba[3] = 255;
        std::memcpy(rgba, source, channels);
    }
}

// Memory that both processes share: an error message, which is empty on success, and then the pixels.
struct Shared {
    static constexpr std::size_t messageBytes = 256;
    std::size_t bytes;
    unsigned char* memory;

    explicit Shared(std::size_t pixelBytes)
        : bytes(messageBytes + pixelBytes),
          memory(static_cast<unsigned char*>(
              mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))) {
        if (memory == MAP_FAILED) throw PictureError("there is not enough memory for its pixels");
    }
    ~Shared() { munmap(memory, bytes); }
    Shared(const Shared&) = delete;
    Shared& operator=(const Shared&) = delete;
};

}  // namespace

// Decodes in a separate process: libktx 4.4 ignores errors in a damaged file's tables and then reads invalid
// memory.
std::vector<std::uint8_t> Ktx2Picture::decode() const {
    constexpr unsigned maxSeconds = 60;
    const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    const Shared shared(4 * pixels);
    std::uint8_t* const rgba = shared.memory + Shared::messageBytes;
    const pid_t decoder = fork();
    if (decoder < 0) throw PictureError("the system cannot start a process to decode it in");
    if (decoder == 0) {
        alarm(maxSeconds);
        try {
            decodeTo(rgba, pixels, bytes_, size_);
        } catch (const std::exception& error) {
            std::strncpy(reinterpret_cast<char*>(shared.memory), error.what(), Shared::messageBytes - 1);
            _exit(1);
        }
        _exit(0);
    }
    int status = 0;
    while (waitpid(decoder, &status, 0) < 0 && errno == EINTR) {
    }
    if (shared.memory[0] != 0) throw PictureError(reinterpret_cast<const char*>(shared.memory));
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw PictureError("libktx cannot decode it, so its data are damaged");
    return {rgba, rgba + 4 * pixels};
}

#else

Ktx2Picture::Ktx2Picture(const unsigned char* bytes, std::size_t size) : bytes_(bytes), size_(size) {
    throw PictureError(
        "it is KTX2, and this build cannot read KTX2; install libktx and build with the CMake option "
        "VCT_KTX=ON");
}

std::vector<std::uint8_t> Ktx2Picture::decode() const {
    return {};
}

#endif

}  // namespace vct
