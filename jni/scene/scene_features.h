// What occurs in a scene, found out once when it is loaded: programs, buffers, targets and calls for the rest
// do not exist. Only what instances place counts; a material that no instance has costs nothing.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace vct {

// What programs differ by, from material to material and, of lights, from scene to scene. Bits; draw calls
// are sorted by them, and those that fewer passes read come first, so that programs change as rarely as
// possible.
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
// Those of the whole scene.
unsigned sharedFeatures(const Scene& scene);

struct SceneFeatures {
    std::vector<unsigned> materialFeatures;  // each combination that occurs once, ascending
    bool glossy = false;                     // a roughness below 1, or a texture of it
    std::vector<bool> textures;              // of Scene::textures: whether a material reads it as a colour
    std::vector<bool> dataTextures;          // likewise as numbers: gloss, or a normal map
    int materials = 0;                       // how many occur
    bool movingObjects = false;              // an animation moves an instance
    bool deforms = false;                    // and changes the form of its mesh
    bool movingLight = false;                // or a light

    // Whether any material has this feature.
    bool has(MaterialFeature feature) const;
};

SceneFeatures featuresOf(const Scene& scene);

}  // namespace vct
