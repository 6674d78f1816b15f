#include "scene/scene_features.h"

#include <algorithm>
#include <set>

namespace vct {

unsigned materialFeatures(const Material& material) {
    unsigned features = 0;
    if (material.doubleSided) features |= featureDoubleSided;
    if (material.emissive != glm::vec3(0.0F)) {
        features |= featureEmissive;
        if (material.emissiveTexture >= 0) features |= featureEmissiveTexture;
    }
    if (material.baseColorTexture >= 0) features |= featureBaseColorTexture;
    if (material.alphaMode == Material::AlphaMode::mask) features |= featureAlphaMask;
    if (material.vertexColors) features |= featureVertexColors;
    if (material.unlit) features |= featureUnlit;
    if (material.glossTexture >= 0) features |= featureGlossTexture;
    if (material.normalTexture >= 0) features |= featureNormalMap;
    return features;
}

unsigned sharedFeatures(const Scene& scene) {
    return scene.mayHavePunctualLights() ? unsigned{featurePunctualLights} : 0U;
}

bool SceneFeatures::has(MaterialFeature feature) const {
    return std::any_of(materialFeatures.begin(), materialFeatures.end(),
                       [&](unsigned features) { return (features & feature) != 0; });
}

SceneFeatures featuresOf(const Scene& scene) {
    std::set<int> materials;
    SceneFeatures found;
    for (const Instance& instance : scene.instances) {
        materials.insert(scene.meshes[instance.mesh].material);
        found.movingObjects |= instance.moves();
        found.deforms |= instance.deforms;
    }
    for (std::size_t i = 0; scene.materialsChange && i < scene.materials.size(); ++i)
        materials.insert(static_cast<int>(i));
    found.materialsChange = scene.materialsChange || scene.instanceRoom > 0;
    const auto moves = [](const auto& light) { return light.node >= 0; };
    found.movingLight = std::any_of(scene.lights.begin(), scene.lights.end(), moves) ||
                        std::any_of(scene.punctualLights.begin(), scene.punctualLights.end(), moves);
    found.textures.resize(scene.textures.size());
    found.holesBelow.resize(scene.textures.size());
    found.dataTextures.resize(scene.textures.size());
    found.materials = static_cast<int>(materials.size());
    std::set<unsigned> combinations;
    for (const int index : materials) {
        const Material& material = scene.materials[index];
        const unsigned features = materialFeatures(material);
        combinations.insert(features | sharedFeatures(scene));
        found.glossy |= material.isGlossy();
        if (features & featureBaseColorTexture) found.textures[material.baseColorTexture] = true;
        if (features & featureBaseColorTexture && features & featureAlphaMask &&
            material.baseColor.a > 0.0F && !found.holesBelow[material.baseColorTexture])
            found.holesBelow[material.baseColorTexture] = material.alphaCutoff / material.baseColor.a;
        if (features & featureEmissiveTexture) found.textures[material.emissiveTexture] = true;
        if (features & featureGlossTexture) found.dataTextures[material.glossTexture] = true;
        if (features & featureNormalMap) found.dataTextures[material.normalTexture] = true;
    }
    found.materialFeatures.assign(combinations.begin(), combinations.end());
    return found;
}

}  // namespace vct
