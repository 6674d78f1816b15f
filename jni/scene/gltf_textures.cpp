#include <stb_image.h>

#include <climits>
#include <cstring>
#include <memory>

#include "scene/gltf_accessors.h"
#include "scene/gltf_materials.h"

namespace vct {
namespace {

constexpr int maxTextureSide = 16384;  // pixels; the largest that current GPUs take

Texture::Wrap wrapMode(const GltfFile& file, int mode) {
    switch (mode) {
        case TINYGLTF_TEXTURE_WRAP_REPEAT:
            return Texture::Wrap::repeat;
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
            return Texture::Wrap::clampToEdge;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
            return Texture::Wrap::mirroredRepeat;
        default:
            file.fail("a texture sampler has the unknown wrap mode " + std::to_string(mode));
    }
}

// glTF allows these two; the other formats that stb reads are its least tested code.
bool isPngOrJpeg(ByteRange bytes) {
    static const unsigned char png[] = {0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A};
    static const unsigned char jpeg[] = {0xFF, 0xD8, 0xFF};
    const auto startsWith = [&](const unsigned char* magic, std::size_t size) {
        return bytes.size >= size && std::memcmp(bytes.data, magic, size) == 0;
    };
    return startsWith(png, sizeof png) || startsWith(jpeg, sizeof jpeg);
}

void decode(GltfFile& file, ByteRange bytes, const std::string& what, Texture& texture) {
    const char* const remedy = "save it again as PNG or JPEG";
    if (!isPngOrJpeg(bytes) || bytes.size > INT_MAX) file.fail(what + " is neither PNG nor JPEG", remedy);
    const int size = static_cast<int>(bytes.size);
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(bytes.data, size, &width, &height, &channels) == 0 || width < 1 || height < 1)
        file.fail(what + " cannot be decoded (" + oneLine(stbi_failure_reason()) + ")", remedy);
    const std::string extent = std::to_string(width) + " x " + std::to_string(height) + " pixels";
    if (width > maxTextureSide || height > maxTextureSide)
        file.fail(what + " has " + extent + ", more than " + std::to_string(maxTextureSide) + " a side",
                  "scale it down");
    // Deflate packs at most 1032 bytes into one and JPEG 512 pixels: more is a lie, not worth its allocation.
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (pixels / 8 > bytes.size * 1032)  // a PNG pixel may be a single bit
        file.fail(what + " says " + extent + " but holds only " + std::to_string(size) + " bytes", remedy);
    file.reserveTexture(pixels * 4);

    const std::unique_ptr<stbi_uc, void (*)(void*)> decoded(
        stbi_load_from_memory(bytes.data, size, &texture.width, &texture.height, &channels, 4),
        stbi_image_free);
    if (decoded == nullptr)
        file.fail(what + " cannot be decoded (" + oneLine(stbi_failure_reason()) + ")", remedy);
    if (texture.width != width || texture.height != height)
        file.fail(what + " contradicts its own size", remedy);
    texture.rgba.assign(decoded.get(), decoded.get() + pixels * 4);
}

}  // namespace

Texture loadTexture(GltfFile& file, int index) {
    const tinygltf::Texture& source = file.at(file.model.textures, index, "texture");
    if (source.source < 0)
        file.fail("texture " + std::to_string(index) + " has no PNG or JPEG image",
                  "export it with PNG or JPEG textures");
    const tinygltf::Image& image = file.at(file.model.images, source.source, "image");

    Texture texture;
    texture.name = image.name.empty() && image.uri.compare(0, 5, "data:") != 0 ? image.uri : image.name;
    if (source.sampler >= 0) {
        const tinygltf::Sampler& sampler = file.at(file.model.samplers, source.sampler, "sampler");
        texture.wrapS = wrapMode(file, sampler.wrapS);
        texture.wrapT = wrapMode(file, sampler.wrapT);
        texture.linearFilter = sampler.magFilter != TINYGLTF_TEXTURE_FILTER_NEAREST;
    } else if (source.sampler < -1) {
        file.fail("texture " + std::to_string(index) + " refers to a negative sampler");
    }

    const std::string what = "image " + std::to_string(source.source) +
                             (texture.name.empty() ? "" : " (" + oneLine(texture.name) + ")");
    if (image.bufferView >= 0) {
        decode(file, viewBytes(file, image.bufferView), what, texture);
    } else {
        if (image.uri.empty()) file.fail(what + " has neither a uri nor a buffer view");
        const std::vector<unsigned char> bytes = readUri(file, image.uri, what);
        decode(file, {bytes.data(), bytes.size()}, what, texture);
    }
    return texture;
}

}  // namespace vct
