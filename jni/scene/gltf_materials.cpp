#include "scene/gltf_materials.h"

#include <algorithm>
#include <cmath>

#include "scene/gltf_extensions.h"

namespace vct {
namespace {

// Returns the number `key` of an extension's object, or `fallback` if there is none.
double number(const tinygltf::Value& object, const std::string& key, double fallback) {
    const tinygltf::Value& value = object.IsObject() ? object.Get(key) : object;
    return value.IsNumber() ? value.GetNumberAsDouble() : fallback;
}

glm::dvec2 vector2(const tinygltf::Value& object, const std::string& key, const glm::dvec2& fallback) {
    if (!object.Has(key)) return fallback;
    const tinygltf::Value& value = object.Get(key);
    if (value.ArrayLen() != 2 || !value.Get(0).IsNumber() || !value.Get(1).IsNumber()) return fallback;
    return {value.Get(0).GetNumberAsDouble(), value.Get(1).GetNumberAsDouble()};
}

float inFloatRange(const GltfFile& file, double value, const std::string& what) {
    if (!(std::abs(value) <= 1e30)) file.fail("the " + what + " of a material is not a usable number");
    return static_cast<float>(value);
}

// Applies KHR_texture_transform: scale, then rotation, then offset. The sign of the rotation is that of the
// extension's example ("lower left quadrant, rotated clockwise") and of the Khronos sample viewer. The matrix
// in the extension's text, read column by column, would rotate the other way.
void applyTransform(const GltfFile& file, const tinygltf::ExtensionMap& extensions, UvSource& uv) {
    const auto found = extensions.find("KHR_texture_transform");
    if (found == extensions.end()) return;
    const tinygltf::Value& transform = found->second;
    const glm::dvec2 scale = vector2(transform, "scale", glm::dvec2(1.0));
    const double angleRad = number(transform, "rotation", 0.0);
    const double c = std::cos(angleRad);
    const double s = std::sin(angleRad);
    uv.offset = vector2(transform, "offset", glm::dvec2(0.0));
    uv.rotationScale = glm::dmat2(c, -s, s, c) * glm::dmat2(scale.x, 0.0, 0.0, scale.y);
    if (transform.Has("texCoord") && transform.Get("texCoord").IsInt())
        uv.texCoord = transform.Get("texCoord").GetNumberAsInt();
    // With values up to 1e9 the results fit into float, because loading limits texture coordinates to 1e9.
    for (const double value : {scale.x, scale.y, angleRad, uv.offset.x, uv.offset.y}) {
        if (!(std::abs(value) <= 1e9)) file.fail("a KHR_texture_transform has a value that is not usable");
    }
}

}  // namespace

const MaterialUse& MaterialLoader::get(int index, bool vertexColors) {
    const auto found = materials_.find({index, vertexColors});
    if (found != materials_.end()) return found->second;
    static const tinygltf::Material defaultMaterial;
    const MaterialUse use =
        load(index == -1 ? defaultMaterial : file_.at(file_.model.materials, index, "material"));
    scene_.materials[static_cast<std::size_t>(use.material)].vertexColors = vertexColors;
    return materials_.emplace(std::pair(index, vertexColors), use).first->second;
}

MaterialUse MaterialLoader::load(const tinygltf::Material& source) {
    Material material;
    MaterialUse use;
    material.name = source.name;
    material.doubleSided = source.doubleSided;

    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    for (int i = 0; i < 4 && i < static_cast<int>(pbr.baseColorFactor.size()); ++i)
        material.baseColor[i] = static_cast<float>(std::clamp(pbr.baseColorFactor[i], 0.0, 1.0));

    material.unlit = extensionOf(source.extensions, "KHR_materials_unlit") != nullptr;
    const tinygltf::Value* const specular =
        extensionOf(source.extensions, "KHR_materials_pbrSpecularGlossiness");
    if (specular != nullptr && !material.unlit) {
        loadSpecularGlossiness(*specular, material, use);
    } else {
        material.baseColorTexture = texture(pbr.baseColorTexture, use.baseColor);
        material.metallic = static_cast<float>(std::clamp(pbr.metallicFactor, 0.0, 1.0));
        material.roughness = static_cast<float>(std::clamp(pbr.roughnessFactor, 0.0, 1.0));
        if (!material.unlit) material.glossTexture = texture(pbr.metallicRoughnessTexture, use.gloss);
    }
    if (material.unlit) {
        material.metallic = 0.0F;
        material.roughness = 1.0F;
    } else {
        loadEmissionAndNormals(source, material, use);
    }

    material.alphaCutoff = inFloatRange(file_, source.alphaCutoff, "alpha cutoff");
    if (source.alphaMode == "MASK") {
        material.alphaMode = Material::AlphaMode::mask;
    } else if (source.alphaMode == "BLEND") {
        // At 0.5 leaves are opaque and their gaps absent, and panes of glass are absent.
        material.alphaMode = Material::AlphaMode::mask;
        material.alphaCutoff = 0.5F;
        file_.warn("blended materials are drawn as masks: opaque where alpha is 0.5 or more, else invisible");
    } else if (!source.alphaMode.empty() && source.alphaMode != "OPAQUE") {
        file_.fail("a material has the unknown alpha mode " + oneLine(source.alphaMode));
    }
    if (isHole(source)) {
        material.alphaMode = Material::AlphaMode::mask;
        material.alphaCutoff = 0.5F;
        material.baseColor.a = 0.0F;
    }
    if (source.occlusionTexture.index >= 0)
        file_.warn("occlusion textures are ignored, because occlusion is computed from the geometry");

    use.material = static_cast<int>(scene_.materials.size());
    scene_.materials.push_back(std::move(material));
    return use;
}

// True if most light passes through the surface (KHR_materials_transmission), as through a pane.
bool MaterialLoader::isHole(const tinygltf::Material& source) {
    const tinygltf::Value* const extension = extensionOf(source.extensions, "KHR_materials_transmission");
    if (extension == nullptr) return false;
    const bool passes = number(*extension, "transmissionFactor", 0.0) >= 0.5;
    const bool textured = extension->Has("transmissionTexture");
    if (passes && !textured)
        file_.warn(
            "surfaces that transmit half of the light or more are holes: invisible, and open to light");
    else
        file_.warn("surfaces that transmit less than half of the light, or by a texture, are opaque");
    return passes && !textured;
}

// Loads emission and normal map, which unlit materials do not have.
void MaterialLoader::loadEmissionAndNormals(const tinygltf::Material& source, Material& material,
                                            MaterialUse& use) {
    double strength = 1.0;
    const auto extension = source.extensions.find("KHR_materials_emissive_strength");
    if (extension != source.extensions.end())
        strength = std::max(number(extension->second, "emissiveStrength", 1.0), 0.0);
    for (int i = 0; i < 3 && i < static_cast<int>(source.emissiveFactor.size()); ++i) {
        const double factor = std::clamp(source.emissiveFactor[i], 0.0, 1.0);
        material.emissive[i] = inFloatRange(file_, factor * strength, "emission");
    }
    material.emissiveTexture = texture(source.emissiveTexture, use.emissive);
    material.normalTexture = texture(source.normalTexture, use.normal);
    material.normalScale = inFloatRange(file_, source.normalTexture.scale, "normal map's scale");
}

template <class Info>
int MaterialLoader::texture(const Info& info, UvSource& uv) {
    if (info.index == -1) return -1;
    uv.hasTexture = true;
    uv.texCoord = info.texCoord;
    applyTransform(file_, info.extensions, uv);
    if (uv.texCoord < 0) file_.fail("a material refers to a negative texture coordinate set");

    return textures_.get(info.index);
}

}  // namespace vct
