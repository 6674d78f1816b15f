// The features that a scene uses, found once when it is loaded. The renderer has programs, buffers, targets
// and calls only for these. Only materials of instances count, unless Scene::materialsChange: an unused
// material costs nothing.
#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"

namespace vct {

// Bits by which programs differ, from material to material or (lights) from scene to scene. Draw calls are
// sorted by them. Bits that fewer passes read come first, in the low digits: passes that ignore them see
// their own bits in order, so programs change rarely.
enum MaterialFeature : unsigned {
    featureDoubleSided = 1,
    featureEmissive = 2,
    featureEmissiveTexture = 4,
    featureBaseColorTexture = 8,
    featureAlphaMask = 16,
    materialFeatureCombinations = 32,
    featurePunctualLights = 32,  // lights besides the sun
    featureVertexColors = 64,
    featureUnlit = 128,
    featureGlossTexture = 256,
    featureNormalMap = 512,
};
unsigned materialFeatures(const Material& material);
// Feature bits that all materials of the scene have.
unsigned sharedFeatures(const Scene& scene);

struct SceneFeatures {
    std::vector<unsigned> materialFeatures;  // the combinations that occur, each once, ascending
    bool glossy = false;                     // a material is glossy
    std::vector<bool> textures;              // per texture of Scene::textures: a material reads it as colour
    // Per texture: the alpha below which the first mask that reads it has a hole; none: no mask does.
    std::vector<std::optional<float>> holesBelow;
    std::vector<bool> dataTextures;  // per texture: read as numbers (gloss, normal map)
    int materials = 0;               // number of materials that occur
    bool movingObjects = false;      // an animation moves an instance
    bool deforms = false;            // an animation deforms a mesh
    bool movingLight = false;        // an animation moves a light
    bool materialsChange = false;    // instances may get other materials, or be added

    // True if any material has this feature.
    bool has(MaterialFeature feature) const;
};

SceneFeatures featuresOf(const Scene& scene);

}  // namespace vct
