// EXT_mesh_gpu_instancing gives the same scene as a node for each instance.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "support/errors.h"
#include "support/gltf_builder.h"

namespace vct::test {
namespace {

const float turn = 0.70710678F;
const std::vector<float> instanceTranslations{1, 0, 0, 0, 2.3F, 0.1F, -4, 0, 5};
const std::vector<float> instanceRotations{0, 0, 0, 1, turn, 0, 0, turn, 0, 0.6F, 0, 0.8F};
const std::vector<float> instanceScales{1, 1, 1, 2, 0.3F, 1, -1, 1, 1};

json three(const std::vector<float>& values, std::size_t i) {
    return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

// Three triangles under a turned node.
struct InstancedScene {
    GltfBuilder builder;
    int parent = 0;

    InstancedScene() {
        builder.triangle();
        parent =
            builder.add("nodes", {{"name", "grove"}, {"rotation", {0, turn, 0, turn}}, {"scale", {2, 1, 1}}});
        builder.document["scenes"][0]["nodes"] = {parent};
    }
    json& attributes() {
        json& node = builder.document["nodes"][static_cast<std::size_t>(parent)];
        node["mesh"] = 0;
        builder.document["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
        builder.document["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
        return node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    }
    void addInstances() {
        attributes() = {{"TRANSLATION", builder.floats(instanceTranslations)},
                        {"ROTATION", builder.floats(instanceRotations, "VEC4")},
                        {"SCALE", builder.floats(instanceScales)}};
    }
    void addNodes() {
        json& nodes = builder.document["nodes"];
        for (std::size_t i = 0; i < 3; ++i) {
            const float* r = &instanceRotations[4 * i];
            nodes[static_cast<std::size_t>(parent)]["children"].push_back(nodes.size());
            nodes.push_back({{"mesh", 0},
                             {"translation", three(instanceTranslations, i)},
                             {"rotation", {r[0], r[1], r[2], r[3]}},
                             {"scale", three(instanceScales, i)}});
        }
    }
    void animateParent() { builder.animate(parent, "translation", {0, 1}, {0, 0, 0, 4, 0.3F, 0}); }
};

void expectSamePlaces(const Scene& instanced, const Scene& nodes, double seconds) {
    ASSERT_EQ(instanced.instances.size(), nodes.instances.size());
    EXPECT_EQ(instanced.meshes.size(), 1U);
    const Pose a = poseAt(instanced.animation, seconds), b = poseAt(nodes.animation, seconds);
    for (std::size_t i = 0; i < nodes.instances.size(); ++i) {
        const Instance &x = instanced.instances[i], &y = nodes.instances[i];
        EXPECT_EQ(x.worldFromObject, y.worldFromObject) << i;
        ASSERT_EQ(x.moves(), y.moves());
        if (x.moves()) {
            EXPECT_EQ(a.worldFromNode[x.node], b.worldFromNode[y.node]) << i;
        }
    }
    EXPECT_EQ(instanced.boundsWorld.min, nodes.boundsWorld.min);
    EXPECT_EQ(instanced.boundsWorld.max, nodes.boundsWorld.max);
}

TEST(Instancing, IsTheSceneWithNodesToTheBit) {
    for (const bool moving : {false, true}) {
        InstancedScene instanced, nodes;
        instanced.addInstances();
        nodes.addNodes();
        if (moving) instanced.animateParent(), nodes.animateParent();
        const Scene scene = load(instanced.builder);
        EXPECT_TRUE(scene.warnings.empty());
        ASSERT_EQ(scene.instances.size(), 3U);
        EXPECT_EQ(scene.instances[0].moves(), moving);
        for (const double seconds : {0.0, 0.37, 1.0})
            expectSamePlaces(scene, load(nodes.builder), seconds);
    }
}

TEST(Instancing, RotationsMayBeNormalizedIntegers) {
    InstancedScene shorts, bytes, floats;
    floats.attributes()["ROTATION"] = floats.builder.floats({0, 0, 0, 1, 0, 1, 0, 0}, "VEC4");
    shorts.attributes()["ROTATION"] = shorts.builder.accessor(
        std::vector<std::int16_t>{0, 0, 0, 32767, 0, 32767, 0, 0}, int16, "VEC4", true);
    bytes.attributes()["ROTATION"] =
        bytes.builder.accessor(std::vector<std::int8_t>{0, 0, 0, 127, 0, 127, 0, 0}, int8, "VEC4", true);
    expectSamePlaces(load(shorts.builder), load(floats.builder), 0.0);
    expectSamePlaces(load(bytes.builder), load(floats.builder), 0.0);
}

TEST(Instancing, ErrorsAreNamed) {
    const auto errorOf = [](const std::vector<float>& translations, const std::vector<float>& rotations) {
        InstancedScene scene;
        scene.attributes() = {{"TRANSLATION", scene.builder.floats(translations)},
                              {"ROTATION", scene.builder.floats(rotations, "VEC4")}};
        return loadError(scene.builder);
    };
    expectMentions(errorOf({1, 2, 3}, {0, 0, 0, 1, 0, 0, 0, 1}),
                   {"node 1 (grove)", "different lengths: 2 and 1"});
    expectMentions(errorOf({1, 2, 3}, {0, 0, 0, 0}), {"node 1 (grove)", "instance 0"});
    expectMentions(errorOf({NAN, 2, 3}, {0, 0, 0, 1}), {"node 1 (grove)", "TRANSLATION"});
    InstancedScene far;
    far.attributes()["TRANSLATION"] = 99;
    expectMentions(loadError(far.builder), {"accessor 99"});
    InstancedScene empty;
    empty.attributes() = json::object();
    expectMentions(loadError(empty.builder), {"node 1 (grove)", "no attributes"});
    InstancedScene flat;
    flat.attributes()["SCALE"] = flat.builder.floats({1, 1, 1, 0, 0, 0});
    EXPECT_TRUE(hasWarning(load(flat.builder), "scaled to zero"));
    EXPECT_EQ(load(flat.builder).instances.size(), 1U);
}

}  // namespace
}  // namespace vct::test
