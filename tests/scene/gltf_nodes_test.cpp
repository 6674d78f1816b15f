#include <gtest/gtest.h>

#include <cmath>

#include "support/gltf_builder.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

void expectNear(const glm::dmat4& a, const glm::dmat4& b) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row)
            EXPECT_NEAR(a[column][row], b[column][row], 1e-9) << column << " " << row;
    }
}

TEST(GltfNodes, TranslationRotationScaleEqualsItsMatrix) {
    // 90 degrees about +Z, scale (2, 3, 4), then (5, 6, 7); matrices are stored by columns.
    const json trs = {{"translation", {5, 6, 7}},
                      {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}},
                      {"scale", {2, 3, 4}}};
    const json matrix = {{"matrix", {0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 5, 6, 7, 1}}};
    for (const json& transform : {trs, matrix}) {
        GltfBuilder builder;
        const int child = builder.triangle();
        builder.document["nodes"][0].update(transform);
        json parent = transform;
        parent["children"] = {child};
        builder.document["scenes"][0]["nodes"] = {builder.add("nodes", parent)};
        const Scene scene = load(builder);
        const glm::dmat4 m({0, 2, 0, 0}, {-3, 0, 0, 0}, {0, 0, 4, 0}, {5, 6, 7, 1});
        expectNear(scene.instances.at(0).worldFromObject, m * m);
    }
}

TEST(GltfNodes, MirroredNodeHasANegativeDeterminant) {
    GltfBuilder builder;
    builder.triangle();
    builder.document["nodes"][0]["scale"] = {-1, 1, 1};
    const Scene scene = load(builder);
    EXPECT_LT(glm::determinant(scene.instances.at(0).worldFromObject), 0.0);
    EXPECT_EQ(scene.boundsWorld.min, glm::dvec3(-1, 0, 0));
    EXPECT_EQ(scene.meshes.at(0).vertices[0].normal, glm::vec3(0, 0, 1));  // object space is not mirrored
}

TEST(GltfNodes, NodeScaledToZeroIsLeftOutWithAWarning) {
    GltfBuilder builder;
    builder.triangle();
    builder.triangle();
    builder.document["nodes"][1]["scale"] = {0, 0, 0};
    const Scene scene = load(builder);
    EXPECT_EQ(scene.instances.size(), 1U);
    EXPECT_TRUE(hasWarning(scene, "zero"));
}

TEST(GltfNodes, DefaultSceneOrTheFirstOrAllRoots) {
    GltfBuilder builder;
    builder.triangle();
    builder.document["nodes"].push_back({{"mesh", 0}, {"translation", {10, 0, 0}}});
    builder.document["scenes"].push_back({{"nodes", {1}}});
    EXPECT_EQ(load(builder).boundsWorld.max.x, 1.0);
    builder.document["scene"] = 1;
    EXPECT_EQ(load(builder).boundsWorld.max.x, 11.0);
    builder.document.erase("scene");
    EXPECT_EQ(load(builder).boundsWorld.max.x, 1.0);
    builder.document.erase("scenes");
    EXPECT_EQ(load(builder).instances.size(), 2U);
}

TEST(GltfNodes, CameraIsRigidAndLooksAlongItsMinusZ) {
    GltfBuilder builder;
    builder.triangle();
    builder.add(
        "cameras",
        {{"type", "perspective"}, {"name", "main"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}});
    builder.add("cameras", {{"type", "orthographic"},
                            {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 1}}}});
    // A quarter turn to the left about +Y: looks along -X. The scale of the parent must not show.
    const int camera =
        builder.add("nodes", {{"camera", 0}, {"rotation", {0, std::sin(pi / 4), 0, std::cos(pi / 4)}}});
    builder.node({{"children", {camera}}, {"scale", {2, 3, 4}}, {"translation", {1, 2, 3}}});
    builder.node({{"camera", 1}});
    const Scene scene = load(builder);
    ASSERT_EQ(scene.cameras.size(), 1U);
    EXPECT_EQ(scene.cameras[0].name, "main");
    EXPECT_EQ(scene.cameras[0].verticalFovRad, 0.7);
    expectNear(scene.cameras[0].worldFromCamera,
               glm::dmat4({0, 0, -1, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}, {1, 2, 3, 1}));
    EXPECT_TRUE(hasWarning(scene, "orthographic"));
}

TEST(GltfNodes, DirectionalLightComesFromPlusZAndScaleIsIgnored) {
    GltfBuilder builder;
    builder.triangle();
    builder.document["extensionsUsed"] = {"KHR_lights_punctual"};
    builder.document["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"color", {0.5, 0.25, 0}}, {"intensity", 8}},
        {{"type", "point"}},
        {{"type", "directional"}}};
    const auto lit = [](int light) { return json{{"KHR_lights_punctual", {{"light", light}}}}; };
    // Half a right angle down: the light travels along (0, -1, -1).
    builder.node({{"extensions", lit(0)},
                  {"rotation", {-std::sin(pi / 8), 0, 0, std::cos(pi / 8)}},
                  {"scale", {3, 3, 3}}});
    builder.node({{"extensions", lit(1)}});
    const Scene scene = load(builder);
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_NEAR(glm::distance(scene.lights[0].towardsLight, glm::dvec3(0, std::sqrt(0.5), std::sqrt(0.5))),
                0.0, 1e-9);
    EXPECT_EQ(scene.lights[0].color, glm::vec3(1.0F, 0.5F, 0.0F));
    EXPECT_EQ(scene.lights[0].intensity, 4.0F);
    EXPECT_TRUE(hasWarning(scene, "point"));
    EXPECT_FALSE(hasWarning(scene, "first one"));

    builder.node({{"extensions", lit(2)}});
    const Scene two = load(builder);
    ASSERT_EQ(two.lights.size(), 2U);
    EXPECT_EQ(two.lights[1].intensity, 1.0F);  // the default of the extension, in lux
    EXPECT_TRUE(hasWarning(two, "first one"));
}

TEST(GltfNodes, WhatIsNotAnimatedIsWarnedOf) {
    GltfBuilder builder;
    builder.triangle();
    builder.document["skins"] = {{{"joints", {0}}}};
    json& primitive = builder.document["meshes"][0]["primitives"][0];
    primitive["attributes"]["COLOR_0"] = 0;
    primitive["targets"] = {{{"POSITION", 0}}};
    const Scene scene = load(builder);
    for (const char* word : {"skins", "COLOR_0", "morph"})
        EXPECT_TRUE(hasWarning(scene, word)) << word;
}

}  // namespace
}  // namespace vct::test
