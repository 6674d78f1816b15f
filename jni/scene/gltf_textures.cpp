// Loads the textures of a glTF file and their images (declared in gltf_materials.h and gltf_packings.h).
#include "core/memory.h"
#include "core/number_text.h"
#include "image/stb_picture.h"
#include "image/webp_picture.h"
#include "scene/gltf_accessors.h"
#include "scene/gltf_extensions.h"
#include "scene/gltf_materials.h"
#include "scene/gltf_packings.h"

namespace vct {
namespace {

constexpr int maxTextureSide = 16384;  // pixels; the limit of current GPUs

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

}  // namespace

int imageOf(const GltfFile& file, int texture) {
    const tinygltf::Texture& source = file.at(file.model.textures, texture, "texture");
    const tinygltf::Value* const webp = extensionOf(source.extensions, "EXT_texture_webp");
    if (webp != nullptr && (readsWebp || source.source < 0)) return indexAt(*webp, "source");
    if (source.source >= 0) return source.source;
    file.fail(
        "texture " + std::to_string(texture) + " has no PNG, JPEG or WebP image, and others are not read",
        "export it with one of these");
}

int TextureLoader::get(int index) {
    const auto found = textures_.find(index);
    if (found != textures_.end()) return found->second;
    Texture texture = load(index);
    const auto [known, isNew] =
        known_.try_emplace({texture.rgba.data(), texture.wrapS, texture.wrapT, texture.linearFilter},
                           static_cast<int>(scene_.textures.size()));
    if (isNew) scene_.textures.push_back(std::move(texture));
    return textures_[index] = known->second;
}

Texture TextureLoader::load(int index) {
    const tinygltf::Texture& source = file_.at(file_.model.textures, index, "texture");
    const int imageIndex = imageOf(file_, index);
    const tinygltf::Image& image = file_.at(file_.model.images, imageIndex, "image");

    Texture texture;
    texture.name = image.name.empty() && image.uri.compare(0, 5, "data:") != 0 ? image.uri : image.name;
    if (source.sampler >= 0) {
        const tinygltf::Sampler& sampler = file_.at(file_.model.samplers, source.sampler, "sampler");
        texture.wrapS = wrapMode(file_, sampler.wrapS);
        texture.wrapT = wrapMode(file_, sampler.wrapT);
        texture.linearFilter = sampler.magFilter != TINYGLTF_TEXTURE_FILTER_NEAREST;
    } else if (source.sampler < -1) {
        file_.fail("texture " + std::to_string(index) + " refers to a negative sampler");
    }
    const Pixels& decoded =
        pixels(image, "image " + indexAndName(static_cast<std::size_t>(imageIndex), texture.name));
    texture.width = decoded.width;
    texture.height = decoded.height;
    texture.rgba = decoded.rgba;
    return texture;
}

const TextureLoader::Pixels& TextureLoader::pixels(const tinygltf::Image& image, const std::string& what) {
    if (image.bufferView < 0 && image.uri.empty()) file_.fail(what + " has neither a uri nor a buffer view");
    const bool inView = image.bufferView >= 0;
    const std::string place = inView ? "" : resolvedUri(file_, image.uri, what);
    const std::string identity =
        inView ? "buffer view " + std::to_string(image.bufferView) : identityOf(place, what);
    const auto known = pixels_.find(identity);
    if (known != pixels_.end()) return known->second;

    std::vector<unsigned char> fileBytes;
    if (!inView) fileBytes = readResolved(file_, place, what);
    const ByteRange bytes =
        inView ? viewBytes(file_, image.bufferView) : ByteRange{fileBytes.data(), fileBytes.size()};
    Pixels result;
    const auto checkSize = [&](const auto& picture) {
        result.width = picture.width();
        result.height = picture.height();
        const std::string extent =
            std::to_string(result.width) + " x " + std::to_string(result.height) + " pixels";
        if (result.width > maxTextureSide || result.height > maxTextureSide)
            file_.fail(
                what + " has " + extent + ", more than " + std::to_string(maxTextureSide) + " per side",
                "scale it down");
        file_.reserveTexture(std::size_t{4} * result.width * result.height, what + ", " + extent + ",");
        if (picture.decodingBytes() > availableMemory())
            file_.fail(what + ", " + extent + ", takes " + megabytesText(picture.decodingBytes()) +
                           " to decode, and only " + megabytesText(availableMemory()) + " are available",
                       std::string("scale it down, or ") + memoryRemedy());
    };
    try {
        if (isWebp(bytes.data, bytes.size)) {
            const WebpPicture picture(bytes.data, bytes.size);
            checkSize(picture);
            result.rgba = picture.decode();
        } else {
            const StbPicture picture(bytes.data, bytes.size);
            checkSize(picture);
            result.rgba = picture.decode(4);
        }
    } catch (const PictureError& error) {
        file_.fail(what + " cannot be decoded: " + asClause(error.what()), "save it again as PNG or JPEG");
    }
    file_.usedBytes -= fileBytes.size();  // the encoded bytes are freed here
    return pixels_.emplace(identity, std::move(result)).first->second;
}

}  // namespace vct
