#include <gtest/gtest.h>

#include <cmath>

#include "support/errors.h"
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

TEST(GltfNodes, AreThoseOfTheDefaultSceneOrTheFirstOrAllRoots) {
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
    // A quarter turn to the left about +Y: looks along -X. The scale of the parent must not show.
    const int camera =
        builder.add("nodes", {{"camera", 0}, {"rotation", {0, std::sin(pi / 4), 0, std::cos(pi / 4)}}});
    builder.node({{"children", {camera}}, {"scale", {2, 3, 4}}, {"translation", {1, 2, 3}}});
    const Scene scene = load(builder);
    ASSERT_EQ(scene.cameras.size(), 1U);
    EXPECT_EQ(scene.cameras[0].name, "main");
    EXPECT_EQ(scene.cameras[0].verticalFovRad, 0.7);
    expectNear(scene.cameras[0].worldFromCamera,
               glm::dmat4({0, 0, -1, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}, {1, 2, 3, 1}));
}

TEST(GltfNodes, AnOrthographicCameraFramesItsAreaInPerspectiveAndComesLast) {
    const auto camerasAt = [](double depth) {
        GltfBuilder builder;
        builder.triangle();  // its centre is (0.5, 0.5, 0)
        builder.add("cameras", {{"type", "orthographic"},
                                {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"zfar", 9}, {"znear", 1}}}});
        builder.add("cameras", {{"type", "orthographic"},
                                {"orthographic", {{"xmag", 0}, {"ymag", 2}, {"zfar", 9}, {"znear", 1}}}});
        builder.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}});
        builder.node({{"camera", 0}, {"translation", {0.5, 0.5, depth}}});
        builder.node({{"camera", 1}});
        builder.node({{"camera", 2}});
        const Scene scene = load(builder);
        EXPECT_TRUE(hasWarning(scene, "drawn in perspective"));
        EXPECT_TRUE(hasWarning(scene, "frames nothing"));
        return scene.cameras;
    };
    const std::vector<Camera> cameras = camerasAt(5.0);
    ASSERT_EQ(cameras.size(), 2U);
    EXPECT_EQ(cameras[0].verticalFovRad, 0.7);
    EXPECT_NEAR(5.0 * std::tan(0.5 * cameras[1].verticalFovRad), 2.0, 1e-12);
    EXPECT_EQ(cameras[1].aspectRatio, 1.5);
    EXPECT_EQ(cameras[1].setBack, 0.0);
    // A camera that is too near moves back until it sees the area at a right angle.
    const std::vector<Camera> near = camerasAt(0.5);
    EXPECT_NEAR(near[1].setBack, 1.5, 1e-12);
    EXPECT_NEAR(near[1].worldFromCamera[3].z, 2.0, 1e-12);
    EXPECT_NEAR(near[1].verticalFovRad, pi / 2, 1e-12);
}

TEST(GltfNodes, LightsPointAlongMinusZAndScaleIsIgnored) {
    GltfBuilder builder;
    builder.triangle();
    builder.document["extensionsUsed"] = {"KHR_lights_punctual"};
    builder.document["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"color", {0.5, 0.25, 0}}, {"intensity", 8}},
        {{"type", "spot"},
         {"range", 7.5},
         {"intensity", 60},
         {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}},
        {{"type", "directional"}},
        {{"type", "point"}, {"intensity", 0}}};
    const auto lit = [](int light) { return json{{"KHR_lights_punctual", {{"light", light}}}}; };
    // Half a right angle down: the light travels along (0, -1, -1).
    builder.node({{"extensions", lit(0)},
                  {"rotation", {-std::sin(pi / 8), 0, 0, std::cos(pi / 8)}},
                  {"scale", {3, 3, 3}}});
    builder.node({{"extensions", lit(1)}, {"translation", {1, 2, 3}}, {"scale", {2, 2, 2}}});
    builder.node({{"extensions", lit(2)}});
    builder.node({{"extensions", lit(3)}});  // gives no light
    const Scene scene = load(builder);
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_NEAR(
        glm::distance(scene.lights[0].directionToLight, glm::dvec3(0, std::sqrt(0.5), std::sqrt(0.5))), 0.0,
        1e-9);
    EXPECT_EQ(scene.lights[0].color, glm::vec3(1.0F, 0.5F, 0.0F));
    EXPECT_EQ(scene.lights[0].intensity, 4.0F);
    // The first directional light is the sun.
    ASSERT_EQ(scene.punctualLights.size(), 2U);
    const PunctualLight& spot = scene.punctualLights[0];
    EXPECT_EQ(spot.type, PunctualLight::Type::spot);
    EXPECT_EQ(glm::dvec3(spot.worldFromLight[3]), glm::dvec3(1, 2, 3));
    EXPECT_EQ(glm::dvec3(spot.worldFromLight[2]), glm::dvec3(0, 0, 1));
    EXPECT_EQ(spot.intensity, 60.0F);
    EXPECT_EQ(spot.range, 7.5);
    EXPECT_EQ(spot.innerConeRad, 0.25);
    EXPECT_EQ(spot.outerConeRad, 0.5);
    EXPECT_EQ(scene.punctualLights[1].type, PunctualLight::Type::directional);
    EXPECT_EQ(scene.punctualLights[1].intensity, 1.0F);  // the default of the extension, in lux
}

// A triangle and one light.
GltfBuilder lightOf(const json& light) {
    GltfBuilder builder;
    builder.triangle();
    builder.document["extensionsUsed"] = {"KHR_lights_punctual"};
    builder.document["extensions"]["KHR_lights_punctual"]["lights"] = json::array({light});
    builder.node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return builder;
}

TEST(GltfNodes, UnusableLightsAreNamed) {
    const std::vector<std::pair<json, std::string>> unusable{
        {{{"type", "point"}, {"range", -1}}, "range"},
        {{{"type", "point"}, {"intensity", -1}}, "negative intensity"},
        {{{"type", "spot"}, {"spot", {{"outerConeAngle", 2}}}}, "angles of its spot"},
        {{{"type", "spot"}, {"spot", {{"innerConeAngle", -1}}}}, "angles of its spot"}};
    for (const auto& [light, named] : unusable)
        expectMentions(errorOf([&] { load(lightOf(light)); }), {"light 0", named});
}

// Everything is as of a file with lengths of half the size, and a light gives surfaces as much as before.
TEST(GltfNodes, AScaleMultipliesAllLengths) {
    GltfBuilder builder = lightOf({{"type", "point"}, {"intensity", 8}, {"range", 10}});
    builder.document["nodes"][0]["translation"] = {4, 0, 0};
    builder.document["nodes"][1]["translation"] = {0, 6, 0};
    builder.node({{"translation", {0, 0, 8}},
                  {"camera", builder.add("cameras", {{"type", "perspective"},
                                                     {"perspective", {{"yfov", 1}, {"znear", 0.2}}}})}});
    const Bytes file = builder.glb();
    const Scene scene = loadGltf("test.glb", [&](const std::string&) { return file; }, {.scale = 0.5});
    EXPECT_EQ(scene.boundsWorld.min, glm::dvec3(2, 0, 0));
    EXPECT_EQ(scene.boundsWorld.max, glm::dvec3(2.5, 0.5, 0));
    const PunctualLight& light = scene.punctualLights.at(0);
    EXPECT_EQ(glm::dvec3(light.worldFromLight[3]), glm::dvec3(0, 3, 0));
    EXPECT_EQ(light.range, 5.0);
    EXPECT_EQ(light.intensity, 2.0F);
    EXPECT_EQ(glm::dvec3(scene.cameras.at(0).worldFromCamera[3]), glm::dvec3(0, 0, 4));
    EXPECT_EQ(scene.cameras.at(0).nearest, 0.1);
}

TEST(GltfNodes, ALightOfAnUnknownTypeIsLeftOutWithAWarning) {
    GltfBuilder builder = lightOf({{"type", "area"}});
    builder.document["extensions"]["KHR_lights_punctual"]["lights"].push_back({{"type", "point"}});
    builder.node({{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
    const Scene scene = load(builder);
    EXPECT_EQ(scene.punctualLights.size(), 1U);
    ASSERT_EQ(scene.warnings.size(), 1U);
    expectMentions(scene.warnings[0], {"light 0", "type 'area'", "left out"});
}

TEST(GltfNodes, ASpotWhoseConesAreEqualHasAHardEdge) {
    for (const double inner : {0.5, 0.6}) {
        const Scene scene =
            load(lightOf({{"type", "spot"}, {"spot", {{"innerConeAngle", inner}, {"outerConeAngle", 0.5}}}}));
        EXPECT_EQ(scene.punctualLights.at(0).innerConeRad, 0.5);
        EXPECT_EQ(scene.punctualLights.at(0).outerConeRad, 0.5);
        ASSERT_EQ(scene.warnings.size(), 1U);
        expectMentions(scene.warnings[0], {"light 0", "edge is hard"});
    }
}

TEST(GltfNodes, AHiddenNodeHidesMeshesAndLightsBelowItButNoCamera) {
    GltfBuilder builder = lightOf({{"type", "point"}});
    builder.document["extensionsUsed"].push_back("KHR_node_visibility");
    const int camera =
        builder.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
    // The children say that they are visible, and are not.
    const json visible{{"KHR_node_visibility", {{"visible", true}}}};
    json light = visible;
    light["KHR_lights_punctual"] = {{"light", 0}};
    const int mesh = builder.add("nodes", {{"mesh", 0}, {"extensions", visible}});
    const int lamp = builder.add("nodes", {{"extensions", light}, {"camera", camera}});
    builder.node(
        {{"children", {mesh, lamp}}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
    const Scene scene = load(builder);
    EXPECT_EQ(scene.instances.size(), 1U);
    EXPECT_EQ(scene.punctualLights.size(), 1U);
    EXPECT_EQ(scene.cameras.size(), 1U);
    EXPECT_TRUE(scene.warnings.empty());
}

}  // namespace
}  // namespace vct::test
