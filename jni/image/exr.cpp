#include <tinyexr.h>

#include <cstdlib>
#include <cstring>

#include "core/error.h"
#include "image/files.h"

namespace vct {
namespace {

// tinyexr's message, freed.
std::string take(const char* message) {
    const std::string text = message != nullptr ? message : "unknown cause";
    if (message != nullptr) FreeEXRErrorMessage(message);
    return text;
}

struct ReadHeader : EXRHeader {
    ReadHeader() { InitEXRHeader(this); }
    ~ReadHeader() { FreeEXRHeader(this); }
    ReadHeader(const ReadHeader&) = delete;
    ReadHeader& operator=(const ReadHeader&) = delete;
};

struct ReadPixels : EXRImage {
    ReadPixels() { InitEXRImage(this); }
    ~ReadPixels() { FreeEXRImage(this); }
    ReadPixels(const ReadPixels&) = delete;
    ReadPixels& operator=(const ReadPixels&) = delete;
};

int channelNamed(const EXRHeader& header, const char* name) {
    for (int i = 0; i < header.num_channels; ++i) {
        if (std::strcmp(header.channels[i].name, name) == 0) return i;
    }
    return -1;
}

}  // namespace

void writeExr(const std::string& path, const Image& image) {
    checkWritable(path, image);
    // Channels lie in the file in alphabetical order, each a plane of its own.
    constexpr int planeCount = 3;
    constexpr const char* names[planeCount] = {"B", "G", "R"};
    std::vector<float> planes[planeCount];
    unsigned char* planePointers[planeCount];
    EXRChannelInfo channels[planeCount] = {};
    int pixelTypes[planeCount];
    for (int i = 0; i < planeCount; ++i) {
        planes[i].reserve(image.pixels.size());
        for (const glm::vec3& pixel : image.pixels)
            planes[i].push_back(pixel[2 - i]);
        planePointers[i] = reinterpret_cast<unsigned char*>(planes[i].data());
        std::strcpy(channels[i].name, names[i]);
        pixelTypes[i] = TINYEXR_PIXELTYPE_FLOAT;
    }
    // Not freed by tinyexr: everything they point to is on this stack.
    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = planeCount;
    header.channels = channels;
    header.pixel_types = pixelTypes;
    header.requested_pixel_types = pixelTypes;
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
    EXRImage pixels;
    InitEXRImage(&pixels);
    pixels.num_channels = planeCount;
    pixels.images = planePointers;
    pixels.width = image.width;
    pixels.height = image.height;

    unsigned char* memory = nullptr;
    const char* message = nullptr;
    const std::size_t size = SaveEXRImageToMemory(&pixels, &header, &memory, &message);
    if (size == 0) {
        throw Error("cannot write picture '" + path + "': EXR encoding failed (" + take(message) +
                    "); choose a smaller size");
    }
    const Bytes file(memory, memory + size);
    std::free(memory);
    replaceFile(path, file);
}

Image decodeExr(const std::string& path, const Bytes& bytes) {
    const auto fail = [&](const std::string& cause) {
        throw Error("cannot read EXR '" + path + "': " + cause + "; make it again");
    };
    checkExrLayout(path, bytes);
    EXRVersion version;
    if (ParseEXRVersionFromMemory(&version, bytes.data(), bytes.size()) != TINYEXR_SUCCESS)
        fail("bad version");
    ReadHeader header;
    const char* message = nullptr;
    if (ParseEXRHeaderFromMemory(&header, &version, bytes.data(), bytes.size(), &message) !=
        TINYEXR_SUCCESS) {
        fail(take(message));
    }
    int planes[3] = {channelNamed(header, "R"), channelNamed(header, "G"), channelNamed(header, "B")};
    if (planes[0] < 0 && planes[1] < 0 && planes[2] < 0) {
        planes[0] = planes[1] = planes[2] = channelNamed(header, "Y");
    }
    for (const int plane : planes) {
        if (plane < 0) fail("it has neither the channels R, G and B nor Y");
        if (header.pixel_types[plane] == TINYEXR_PIXELTYPE_UINT) fail("its colours are integers");
    }
    for (int i = 0; i < header.num_channels; ++i) {
        if (header.pixel_types[i] == TINYEXR_PIXELTYPE_HALF) {
            header.requested_pixel_types[i] = TINYEXR_PIXELTYPE_FLOAT;
        }
    }
    ReadPixels pixels;
    // tinyexr 1.0.1 frees the planes itself where decoding fails, but only as many as are counted here.
    pixels.num_channels = header.num_channels;
    if (LoadEXRImageFromMemory(&pixels, &header, bytes.data(), bytes.size(), &message) != TINYEXR_SUCCESS) {
        InitEXRImage(&pixels);  // all freed, but the pointers are still there
        fail(take(message));
    }
    Image image(pixels.width, pixels.height);
    for (int c = 0; c < 3; ++c) {
        const auto* plane = reinterpret_cast<const float*>(pixels.images[planes[c]]);
        for (glm::vec3& pixel : image.pixels)
            pixel[c] = *plane++;
    }
    return image;
}

}  // namespace vct
