// What a scene does not need does not exist: calls, programs, bindings and memory are those of a scene that
// never heard of it.
#include "scene/scene_features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/error.h"
#include "gl/call_log.h"
#include "scene/camera.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

struct Feature {
    const char* name;
    void (*give)(Material& material);
    const char* preset;
};
void PrintTo(const Feature& feature, std::ostream* out) {
    *out << feature.name << ", " << feature.preset;
}

const std::vector<Feature>& allFeaturesOfAllPresets() {
    const std::vector<Feature> features{
        {"BaseColorTexture", [](Material& m) { m.baseColorTexture = 0; }, ""},
        {"AlphaMask", [](Material& m) { m.alphaMode = Material::AlphaMode::mask; }, ""},
        {"Emission", [](Material& m) { m.emissive = glm::vec3(2.0F); }, ""},
        {"EmissiveTexture",
         [](Material& m) {
             m.emissive = glm::vec3(2.0F);
             m.emissiveTexture = 1;
         },
         ""},
        {"Glossy", [](Material& m) { m.roughness = 0.3F; }, ""},
        {"DoubleSided", [](Material& m) { m.doubleSided = true; }, ""},
        {"GlossTexture", [](Material& m) { m.glossTexture = 0; }, ""},
        {"NormalMap", [](Material& m) { m.normalTexture = 0; }, ""},
        {"VertexColors", [](Material& m) { m.vertexColors = true; }, ""},
        {"Unlit", [](Material& m) { m.unlit = true; }, ""},
    };
    static std::vector<Feature> all;
    if (all.empty())
        for (const char* preset : {"thesis", "mobile"})
            for (Feature feature : features) {
                feature.preset = preset;
                all.push_back(feature);
            }
    return all;
}

// A floor and a box on it. Materials: 0 of the floor, 1 the featured one, 2 of the box where it is plain.
Scene sceneWith(const Feature* declared, bool used) {
    Scene scene = emptyScene();
    scene.materials.resize(3);
    if (declared != nullptr) {
        declared->give(scene.materials[1]);
        for (int i = 0; i < 2; ++i)
            scene.textures.push_back({"", 4, 4, std::vector<std::uint8_t>(64, 200)});
    }
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, 0);
    addBox(scene, {0.5, 0.5, 0.5}, {0, 0.25, 0}, used ? 1 : 2);
    return finished(std::move(scene));
}

// What a renderer asks of GL, from its constructor to its third frame.
struct Asked {
    std::vector<std::string> programs;  // built, by name
    std::vector<std::string> sources;   // compiled
    gl::CallSummary frame;              // of the third frame
    std::map<std::string, std::size_t> bytes;
};

Settings featureSettings(const std::string& preset) {
    Settings settings = presetSettings(preset);
    settings.grid = 64;
    settings.size = glm::ivec2(32);
    settings.shadowMapSize = 64;
    settings.revoxelize = true;
    return settings;
}

const Camera viewOfFloor = lookAt({0, 2, 3}, {0, 0, 0}, 40);

Asked askedBy(const Scene& scene, const std::string& preset, Output mode = Output::giConeShadow) {
    const Context context = openContext(Backend::egl);
    gl::CallLog log;
    Renderer renderer = makeRenderer(context, scene, lightFrom({1, 2, 1}), featureSettings(preset));
    int frames = 0;
    const auto frame = [&] {
        if (!scene.animation.channels.empty()) renderer.setPose(poseAt(scene.animation, 0.1 * frames++));
        renderer.render({{mode}, viewOfFloor});
    };
    frame();
    frame();
    Asked asked;
    for (const gl::Call& call : log.calls()) {
        if (std::string(call.name) == "ShaderSource") asked.sources.push_back(call.text);
        if (std::string(call.name) == "ObjectLabel" && call.arguments[0] == GL_PROGRAM)
            asked.programs.push_back(call.text);
    }
    log.clear();
    frame();
    asked.frame = gl::summarize(log.calls());
    for (const Resource& resource : renderer.resources())
        asked.bytes[resource.name] += resource.bytes;
    return asked;
}

void expectEqual(const Asked& a, const Asked& b) {
    EXPECT_EQ(a.programs, b.programs);
    EXPECT_EQ(a.sources, b.sources);
    EXPECT_EQ(a.frame.byName, b.frame.byName);
    EXPECT_EQ(a.frame.byGroup, b.frame.byGroup);
    EXPECT_EQ(a.frame.bindings, b.frame.bindings);
    EXPECT_EQ(a.bytes, b.bytes);
}

// Of the scene that never heard of any feature; once for each preset.
const Asked& askedByPlain(const std::string& preset) {
    static std::map<std::string, Asked> known;
    if (known.count(preset) == 0) known[preset] = askedBy(sceneWith(nullptr, false), preset);
    return known[preset];
}

class FeatureOfAScene : public ::testing::TestWithParam<Feature> {};

TEST_P(FeatureOfAScene, WhatNoInstanceHasCostsNothing) {
    const Feature& feature = GetParam();
    const Asked& never = askedByPlain(feature.preset);
    EXPECT_GT(never.frame.calls, 100);
    EXPECT_FALSE(never.frame.bindings.empty());
    expectEqual(askedBy(sceneWith(&feature, false), feature.preset), never);
}

// The thesis's voxels reflect nothing.
TEST_P(FeatureOfAScene, WhatAnInstanceHasIsInItsShaders) {
    const Feature& feature = GetParam();
    const bool isGloss = std::string(feature.name) == "Glossy" || std::string(feature.name) == "GlossTexture";
    const bool reflects = !isGloss || std::string(feature.preset) != "thesis";
    const Asked with = askedBy(sceneWith(&feature, true), feature.preset);
    EXPECT_EQ(with.sources != askedByPlain(feature.preset).sources, reflects);
}

INSTANTIATE_TEST_SUITE_P(Features, FeatureOfAScene, ::testing::ValuesIn(allFeaturesOfAllPresets()),
                         [](const ::testing::TestParamInfo<Feature>& test) {
                             return std::string(test.param.name) + "_" + test.param.preset;
                         });

const Feature& featureNamed(const std::string& name, const std::string& preset) {
    for (const Feature& feature : allFeaturesOfAllPresets())
        if (feature.name == name && feature.preset == preset) return feature;
    throw Error("no feature " + name);
}

// Of a texture the G-buffer and voxelization know; neither the shadow of an opaque surface nor which voxels
// it touches depends on it.
TEST(SceneFeatures, AddNoMoreThanTheyNeed) {
    const Asked& plain = askedByPlain("mobile");
    struct Added {
        const char* feature;
        std::size_t programs;
        int targets, textures;
    };
    for (const Added& added :
         {Added{"BaseColorTexture", 2, 0, 2}, Added{"Emission", 2, 1, 0}, Added{"Glossy", 0, 1, 0},
          Added{"DoubleSided", 2, 0, 0}, Added{"GlossTexture", 1, 1, 1}, Added{"NormalMap", 1, 0, 1},
          Added{"VertexColors", 2, 0, 0}, Added{"Unlit", 2, 1, 0}}) {
        Asked with = askedBy(sceneWith(&featureNamed(added.feature, "mobile"), true), "mobile");
        const auto more = [&](const char* call) {
            return with.frame.byName.at(call) - plain.frame.byName.at(call);
        };
        EXPECT_EQ(with.programs.size(), plain.programs.size() + added.programs) << added.feature;
        EXPECT_EQ(more("ClearBufferfv"), added.targets) << added.feature;
        if (added.targets == 0) {
            EXPECT_EQ(more("BindTexture"), added.textures) << added.feature;
        }
        EXPECT_EQ(with.bytes["scene textures"] > 0, added.textures > 0) << added.feature;
    }
}

TEST(SceneFeatures, GlossThatIsNotDrawnCostsNothing) {
    expectEqual(askedBy(sceneWith(&featureNamed("Glossy", "thesis"), true), "thesis"),
                askedByPlain("thesis"));
}

TEST(SceneFeatures, LightsBesidesTheSunCostNothingButWhereTheyShine) {
    Scene scene = sceneWith(nullptr, false);
    scene.punctualLights.emplace_back();
    scene.punctualLights[0].worldFromLight[3] = glm::dvec4(0.3, 1.2, 0.5, 1.0);
    for (const char* preset : {"thesis", "mobile"}) {
        const Asked plain = askedByPlain(preset), with = askedBy(scene, preset);
        for (const std::string& source : plain.sources)
            EXPECT_EQ(source.find("#define VCT_PUNCTUAL_LIGHTS"), std::string::npos) << preset;
        EXPECT_EQ(with.programs.size(), plain.programs.size() + 1) << preset;  // of the maps
        EXPECT_EQ(with.bytes.size(), plain.bytes.size() + 2) << preset;        // uniforms and maps
        EXPECT_EQ(with.frame.draws, plain.frame.draws + 6 * 2) << preset;      // floor and box in six maps
        EXPECT_EQ(with.frame.dispatches, plain.frame.dispatches) << preset;
    }
}

TEST(SceneFeatures, MaterialsThatDifferInNumbersAloneShareEveryProgram) {
    Scene one = sceneWith(nullptr, false);
    Scene several = one;
    several.materials[2].baseColor = {0.5F, 0.1F, 0.1F, 1.0F};
    for (Mesh& mesh : one.meshes)
        mesh.material = 0;
    ASSERT_EQ(featuresOf(one).materials, 1);
    ASSERT_EQ(featuresOf(several).materials, 2);
    for (const char* preset : {"thesis", "mobile"})
        expectEqual(askedBy(several, preset), askedBy(one, preset));
}

TEST(SceneFeatures, AnAnimationCostsNothingButWhereItMovesAnObject) {
    Scene scene = sceneWith(nullptr, false);
    scene.animation.nodes.resize(1);
    AnimationChannel slide;
    slide.times = {0.0F, 1.0F};
    slide.values = {glm::dvec4(0.0), glm::dvec4(0.5, 0.0, 0.0, 0.0)};
    scene.animation.channels.push_back(slide);
    scene.animation.durationS = 1.0;
    scene.lights.push_back(lightFrom({1, 2, 1}));
    scene.lights[0].node = 0;
    EXPECT_TRUE(featuresOf(scene).movingLight);
    EXPECT_FALSE(featuresOf(scene).movingObjects);
    expectEqual(askedBy(scene, "mobile"), askedByPlain("mobile"));

    scene.instances[1].node = 0;
    EXPECT_TRUE(featuresOf(scene).movingObjects);
    const Asked moving = askedBy(scene, "mobile");

    EXPECT_EQ(moving.programs.size(), askedByPlain("mobile").programs.size());
    EXPECT_GT(moving.frame.byName.at("BufferSubData"),
              askedByPlain("mobile").frame.byName.at("BufferSubData"));
}

TEST(SceneFeatures, AModeBuildsTheProgramsThatItAsksFor) {
    const Scene scene = sceneWith(nullptr, false);
    const auto builds = [&](Output mode, const std::string& program) {
        const std::vector<std::string> programs = askedBy(scene, "mobile", mode).programs;
        return std::count(programs.begin(), programs.end(), program) > 0;
    };
    EXPECT_FALSE(builds(Output::phong, "shadow_map"));
    EXPECT_TRUE(builds(Output::shadowMap, "shadow_map"));
    EXPECT_FALSE(builds(Output::shadowMap, "directional/accumulate"));
    EXPECT_TRUE(builds(Output::ao, "directional/accumulate"));
    EXPECT_FALSE(builds(Output::ao, "inject"));
    EXPECT_TRUE(builds(Output::ao, "inject, direct light"));
    EXPECT_FALSE(builds(Output::ao, "gather"));
    EXPECT_TRUE(builds(Output::gi, "inject"));
    EXPECT_FALSE(builds(Output::gi, "gather, occlusion"));
}

TEST(SceneFeatures, OnlyWhatIsPlacedAndSeenCounts) {
    Scene scene = sceneWith(nullptr, false);
    Material& material = scene.materials[1];
    material.emissiveTexture = 0;  // of an emission of zero
    material.doubleSided = true;
    scene.textures.resize(1);
    EXPECT_FALSE(featuresOf(scene).has(featureDoubleSided));
    scene.meshes[1].material = 1;
    const SceneFeatures features = featuresOf(scene);
    EXPECT_EQ(features.materialFeatures, (std::vector<unsigned>{0, featureDoubleSided}));
    EXPECT_EQ(features.textures, std::vector<bool>{false});
    EXPECT_FALSE(features.has(featureEmissive));
    EXPECT_FALSE(features.glossy);
    EXPECT_EQ(features.materials, 2);
}

}  // namespace
}  // namespace vct::test
