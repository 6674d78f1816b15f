// Converts materials of KHR_materials_pbrSpecularGlossiness (declared in gltf_materials.h).
#include <algorithm>
#include <cmath>

#include "image/image.h"
#include "scene/gltf_extensions.h"
#include "scene/gltf_materials.h"

namespace vct {
namespace {

constexpr float dielectricSpecular = 0.04F;  // reflectance at normal incidence of a material with metallic 0

struct MetallicRoughness {
    glm::vec3 baseColor;
    float metallic;
};

// Brightness of a linear RGB colour, with the weights of ITU-R BT.601, as in the source of converted().
float perceivedBrightness(const glm::vec3& color) {
    return std::sqrt(glm::dot(glm::vec3(0.299F, 0.587F, 0.114F), color * color));
}

// Converts by the method that Khronos publishes with KHR_materials_pbrSpecularGlossiness
// (examples/convert-between-workflows): it solves for the value of metallic at which both models have the
// same diffuse and specular brightness. Colours are linear RGB; `specular` is the reflectance at normal
// incidence.
MetallicRoughness converted(const glm::vec3& diffuse, const glm::vec3& specular) {
    const float lost = 1.0F - std::max({specular.r, specular.g, specular.b});
    const float specularBrightness = perceivedBrightness(specular);
    float metallic = 0.0F;
    if (specularBrightness >= dielectricSpecular) {
        const float b = perceivedBrightness(diffuse) * lost / (1.0F - dielectricSpecular) +
                        specularBrightness - 2.0F * dielectricSpecular;
        const float discriminant =
            std::max(b * b - 4.0F * dielectricSpecular * (dielectricSpecular - specularBrightness), 0.0F);
        metallic = std::clamp((std::sqrt(discriminant) - b) / (2.0F * dielectricSpecular), 0.0F, 1.0F);
    }
    constexpr float least = 1e-6F;
    const glm::vec3 diffuseColor =
        diffuse * (lost / ((1.0F - dielectricSpecular) * std::max(1.0F - metallic, least)));
    const glm::vec3 specularColor =
        (specular - dielectricSpecular * (1.0F - metallic)) / std::max(metallic, least);
    return {glm::clamp(glm::mix(diffuseColor, specularColor, metallic * metallic), 0.0F, 1.0F), metallic};
}

glm::vec4 factors(const tinygltf::Value& object, const char* key, int count) {
    glm::vec4 result(1.0F);
    if (!object.Has(key) || static_cast<int>(object.Get(key).ArrayLen()) != count) return result;
    for (int i = 0; i < count; ++i) {
        const tinygltf::Value& value = object.Get(key).Get(i);
        if (value.IsNumber()) result[i] = static_cast<float>(std::clamp(value.GetNumberAsDouble(), 0.0, 1.0));
    }
    return result;
}

// Converts an extension's reference to a texture to tinygltf's usual type.
tinygltf::TextureInfo textureInfo(const tinygltf::Value& object, const char* key) {
    tinygltf::TextureInfo info;
    if (!object.Has(key)) return info;
    const tinygltf::Value& source = object.Get(key);
    info.index = indexAt(source, "index");
    info.texCoord = std::max(indexAt(source, "texCoord"), 0);
    if (source.Has("extensions") && source.Get("extensions").IsObject())
        info.extensions = source.Get("extensions").Get<tinygltf::Value::Object>();
    return info;
}

// Returns the texel of `texture` at the position of texel (x, y) of a picture of `width` by `height`, with
// linear colour; white if there is no texture.
glm::vec4 texelAt(const Texture* texture, int x, int y, int width, int height) {
    if (texture == nullptr) return glm::vec4(1.0F);
    const auto along = [](int at, int count, int own) {
        return static_cast<std::size_t>((static_cast<std::int64_t>(at) * 2 + 1) * own /
                                        (std::int64_t{2} * count));
    };
    const std::size_t row = along(y, height, texture->height), column = along(x, width, texture->width);
    const std::uint8_t* code =
        texture->rgba.data() + (row * static_cast<std::size_t>(texture->width) + column) * 4;
    glm::vec4 result(0.0F, 0.0F, 0.0F, static_cast<float>(code[3]) / 255.0F);
    for (int c = 0; c < 3; ++c)
        result[c] = srgbDecode(static_cast<float>(code[c]) / 255.0F);
    return result;
}

std::uint8_t codeOf(float value) {
    return static_cast<std::uint8_t>(value * 255.0F + 0.5F);
}

}  // namespace

void MaterialLoader::loadSpecularGlossiness(const tinygltf::Value& extension, Material& material,
                                            MaterialUse& use) {
    const glm::vec4 diffuseFactor = factors(extension, "diffuseFactor", 4);
    const glm::vec4 specularFactor = factors(extension, "specularFactor", 3);
    float glossiness = 1.0F;
    if (extension.Has("glossinessFactor") && extension.Get("glossinessFactor").IsNumber())
        glossiness =
            static_cast<float>(std::clamp(extension.Get("glossinessFactor").GetNumberAsDouble(), 0.0, 1.0));
    use.baseColor = use.gloss = UvSource();
    material.baseColorTexture = texture(textureInfo(extension, "diffuseTexture"), use.baseColor);
    const int specularTexture = texture(textureInfo(extension, "specularGlossinessTexture"), use.gloss);

    if (material.baseColorTexture < 0 && specularTexture < 0) {
        const MetallicRoughness result = converted(glm::vec3(diffuseFactor), glm::vec3(specularFactor));
        material.baseColor = glm::vec4(result.baseColor, diffuseFactor.a);
        material.metallic = result.metallic;
        material.roughness = 1.0F - glossiness;
        return;
    }
    // The metallic value depends on both colours, so every texel is converted.
    const auto picture = [&](int index) {
        return index < 0 ? nullptr : &scene_.textures[static_cast<std::size_t>(index)];
    };
    const Texture* const diffuse = picture(material.baseColorTexture);
    const Texture* const specular = picture(specularTexture);
    if (diffuse != nullptr && specular != nullptr && !use.baseColor.isSameAs(use.gloss))
        file_.warn(
            "a specular texture lies elsewhere than its diffuse texture; both are placed by the coordinates "
            "of "
            "the diffuse texture");
    Texture color = diffuse != nullptr ? *diffuse : *specular;
    if (specular != nullptr && color.width * color.height < specular->width * specular->height) {
        color.width = specular->width;
        color.height = specular->height;
    }
    const std::size_t bytes = std::size_t{4} * color.width * color.height;
    file_.reserveTexture(2 * bytes, "a converted material of KHR_materials_pbrSpecularGlossiness");
    std::vector<std::uint8_t> colorCodes, glossCodes;
    colorCodes.reserve(bytes);
    glossCodes.reserve(bytes);
    for (int y = 0; y < color.height; ++y)
        for (int x = 0; x < color.width; ++x) {
            const glm::vec4 diffuseColor = diffuseFactor * texelAt(diffuse, x, y, color.width, color.height);
            const glm::vec4 specularColor = glm::vec4(glm::vec3(specularFactor), glossiness) *
                                            texelAt(specular, x, y, color.width, color.height);
            const MetallicRoughness result = converted(glm::vec3(diffuseColor), glm::vec3(specularColor));
            for (int c = 0; c < 3; ++c)
                colorCodes.push_back(codeOf(srgbEncode(result.baseColor[c])));
            colorCodes.push_back(codeOf(diffuseColor.a));
            glossCodes.insert(glossCodes.end(),
                              {0, codeOf(1.0F - specularColor.a), codeOf(result.metallic), 255});
        }
    color.rgba = std::move(colorCodes);
    Texture gloss = color;
    gloss.rgba = std::move(glossCodes);
    if (diffuse == nullptr) use.baseColor = use.gloss;
    use.gloss = use.baseColor;
    material.baseColor = glm::vec4(1.0F);
    material.metallic = material.roughness = 1.0F;
    material.baseColorTexture = static_cast<int>(scene_.textures.size());
    scene_.textures.push_back(std::move(color));
    material.glossTexture = static_cast<int>(scene_.textures.size());
    scene_.textures.push_back(std::move(gloss));
}

}  // namespace vct
