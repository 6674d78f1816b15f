// A scene pays only for the features that occur in it: other scenes link no programs and have no memory for
// them.
#include "scene/scene_features.h"

#include <gtest/gtest.h>

#include <map>

#include "support/gl_spy.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

struct Feature {
    const char* name;
    void (*give)(Material& material);
};

// A floor and a box on it. Material 1 has the feature; the box has that material or the plain one.
Scene sceneWith(const Feature& feature, bool used) {
    Scene scene = emptyScene();
    scene.materials.resize(3);
    feature.give(scene.materials[1]);
    for (int i = 0; i < 2; ++i)
        scene.textures.push_back({"", 4, 4, std::vector<std::uint8_t>(64, 200)});
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, 0);
    addBox(scene, {0.5, 0.5, 0.5}, {0, 0.25, 0}, used ? 1 : 2);
    return finished(std::move(scene));
}

struct Price {
    int programs = 0;
    std::map<std::string, std::size_t> bytes;
};

Price priceOf(const Scene& scene, const char* preset) {
    const Context context = openContext(Backend::egl);
    Settings settings = presetSettings(preset);
    settings.grid = 64;
    settings.size = glm::ivec2(32);
    Price price;
    const GlSpy<&gl::LinkProgram> links([&](GLuint) { ++price.programs; });
    Renderer renderer = makeRenderer(context, scene, lightFrom({1, 2, 1}), settings);
    renderer.render({{Output::giConeShadow}, lookAt({0, 2, 3}, {0, 0, 0}, 40)});
    for (const Resource& resource : renderer.resources())
        price.bytes[resource.name] += resource.bytes;
    return price;
}

class ScenePrices : public ::testing::TestWithParam<const char*> {};

TEST_P(ScenePrices, AFeatureCostsNothingUntilATriangleHasIt) {
    const Feature features[] = {
        {"alpha mask", [](Material& m) { m.alphaMode = Material::AlphaMode::mask; }},
        {"emission", [](Material& m) { m.emissive = glm::vec3(2.0F); }},
        {"gloss", [](Material& m) { m.roughness = 0.3F; }},
        {"normal map", [](Material& m) { m.normalTexture = 0; }},
        {"base colour texture", [](Material& m) { m.baseColorTexture = 0; }},
        {"vertex colours", [](Material& m) { m.vertexColors = true; }},
        {"unlit", [](Material& m) { m.unlit = true; }},
    };
    const Price plain = priceOf(sceneWith({"none", [](Material&) {}}, false), GetParam());
    for (const Feature& feature : features) {
        SCOPED_TRACE(feature.name);
        const Price unused = priceOf(sceneWith(feature, false), GetParam());
        EXPECT_EQ(unused.programs, plain.programs);
        EXPECT_EQ(unused.bytes, plain.bytes);
    }
    // The scene that uses emission shows that the test sees programs and memory.
    const Price used = priceOf(sceneWith(features[1], true), GetParam());
    EXPECT_GT(used.programs, plain.programs);
    EXPECT_NE(used.bytes, plain.bytes);
}

INSTANTIATE_TEST_SUITE_P(Presets, ScenePrices, ::testing::Values("thesis", "mobile"));

}  // namespace
}  // namespace vct::test
