// The features of a scene decide which programs, targets and buffers its renderer has.
#include "scene/scene_features.h"

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace vct::test {
namespace {

// A floor and a box on it. Materials: 0 of the floor, 1 of nothing, 2 of the box.
Scene floorAndBox() {
    Scene scene = emptyScene();
    scene.materials.resize(3);
    scene.textures.resize(2);
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, 0);
    addBox(scene, {0.5, 0.5, 0.5}, {0, 0.25, 0}, 2);
    return finished(std::move(scene));
}

struct Feature {
    const char* name;
    void (*give)(Material& material);
    unsigned bits;
    bool isGlossy = false;
};
const Feature features[] = {
    {"base colour texture", [](Material& m) { m.baseColorTexture = 0; }, featureBaseColorTexture},
    {"alpha mask", [](Material& m) { m.alphaMode = Material::AlphaMode::mask; }, featureAlphaMask},
    {"emission", [](Material& m) { m.emissive = glm::vec3(2.0F); }, featureEmissive},
    {"emissive texture",
     [](Material& m) {
         m.emissive = glm::vec3(2.0F);
         m.emissiveTexture = 1;
     },
     featureEmissive | featureEmissiveTexture},
    {"emissive texture of black", [](Material& m) { m.emissiveTexture = 1; }, 0},
    {"gloss", [](Material& m) { m.roughness = 0.3F; }, 0, true},
    {"two sides", [](Material& m) { m.doubleSided = true; }, featureDoubleSided},
    {"gloss texture", [](Material& m) { m.glossTexture = 0; }, featureGlossTexture, true},
    {"normal map", [](Material& m) { m.normalTexture = 0; }, featureNormalMap},
    {"vertex colours", [](Material& m) { m.vertexColors = true; }, featureVertexColors},
    {"unlit", [](Material& m) { m.unlit = true; }, featureUnlit},
};

TEST(SceneFeatures, AMaterialCountsOnlyWhereAnInstanceHasIt) {
    for (const Feature& feature : features) {
        Scene scene = floorAndBox();
        feature.give(scene.materials[1]);
        const SceneFeatures unused = featuresOf(scene);
        EXPECT_EQ(unused.materialFeatures, std::vector<unsigned>{0}) << feature.name;
        EXPECT_EQ(unused.textures, std::vector<bool>(2)) << feature.name;
        EXPECT_EQ(unused.dataTextures, std::vector<bool>(2)) << feature.name;
        EXPECT_FALSE(unused.glossy) << feature.name;
        scene.meshes[1].material = 1;
        const SceneFeatures used = featuresOf(scene);
        EXPECT_EQ(used.materialFeatures.back(), feature.bits) << feature.name;
        EXPECT_EQ(used.glossy, feature.isGlossy) << feature.name;
    }
}

TEST(SceneFeatures, AnAnimationCountsWhereItMovesAnObjectOrALight) {
    Scene scene = floorAndBox();
    scene.animation.nodes.resize(1);
    AnimationChannel slide;
    slide.times = {0.0F, 1.0F};
    slide.values = {glm::dvec4(0.0), glm::dvec4(0.5, 0.0, 0.0, 0.0)};
    scene.animation.channels.push_back(slide);
    scene.lights.push_back(lightFrom({1, 2, 1}));
    scene.lights[0].node = 0;
    EXPECT_TRUE(featuresOf(scene).movingLight);
    EXPECT_FALSE(featuresOf(scene).movingObjects);
    scene.instances[1].node = 0;
    EXPECT_TRUE(featuresOf(scene).movingObjects);
}

}  // namespace
}  // namespace vct::test
