// Node animations from a glTF file: matrices at a time, computed by hand, and errors.
#include "scene/animation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/errors.h"
#include "support/gltf_builder.h"

namespace vct::test {
namespace {

constexpr float noNumber = std::numeric_limits<float>::quiet_NaN();
const float half = std::sqrt(0.5F);

// The matrix of instance 0 at a time.
glm::dmat4 at(const Scene& scene, double seconds) {
    return poseAt(scene.animation, seconds)
        .worldFromNode.at(static_cast<std::size_t>(scene.instances.at(0).node));
}
glm::dvec3 placeAt(const Scene& scene, double seconds) {
    return at(scene, seconds)[3];
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b, const std::string& what, double tolerance = 1e-6) {
    EXPECT_NEAR(glm::distance(a, b), 0.0, tolerance) << what << ": " << a.x << " " << a.y << " " << a.z
                                                     << ", expected " << b.x << " " << b.y << " " << b.z;
}

// A triangle that an animation of one channel moves.
Scene moved(const std::string& path, const std::vector<float>& times, const std::vector<float>& values,
            const std::string& interpolation = "LINEAR") {
    GltfBuilder builder;
    builder.animate(builder.triangle(), path, times, values, interpolation);
    return load(builder);
}

TEST(Animation, LinearKeysAreJoinedByStraightLinesAndHeldAtBothEnds) {
    const Scene scene = moved("translation", {1, 3}, {0, 0, 0, 4, 8, -2});
    EXPECT_EQ(scene.animation.durationS, 3.0);
    for (const double early : {0.0, 0.5, 1.0})
        EXPECT_EQ(placeAt(scene, early), glm::dvec3(0)) << early;
    EXPECT_EQ(placeAt(scene, 1.5), glm::dvec3(1, 2, -0.5));
    EXPECT_EQ(placeAt(scene, 2.0), glm::dvec3(2, 4, -1));
    for (const double late : {3.0, 3.5, 1e9})
        EXPECT_EQ(placeAt(scene, late), glm::dvec3(4, 8, -2)) << late;
}

TEST(Animation, StepKeysHoldUntilTheNext) {
    const Scene scene = moved("translation", {0, 1, 2}, {5, 0, 0, 6, 0, 0, 7, 0, 0}, "STEP");
    EXPECT_EQ(placeAt(scene, 0.999).x, 5.0);
    EXPECT_EQ(placeAt(scene, 1.0).x, 6.0);
    EXPECT_EQ(placeAt(scene, 1.999).x, 6.0);
    EXPECT_EQ(placeAt(scene, 2.0).x, 7.0);
}

// Values are in-tangent, value, out-tangent. Over 2 s from value 1 with tangent 3 to value 5 with tangent -1,
// by hand: u = 1/4: 0.84375 * 1 + 2 * 0.140625 * 3 + 0.15625 * 5 + 2 * -0.046875 * -1 = 2.5625.
TEST(Animation, CubicSplineFollowsItsTangents) {
    const Scene scene =
        moved("translation", {1, 3}, {9, 9, 9, 1, 0, 0, 3, 0, 0, -1, 0, 0, 5, 0, 0, 9, 9, 9}, "CUBICSPLINE");
    EXPECT_EQ(placeAt(scene, 0.0), glm::dvec3(1, 0, 0));
    EXPECT_EQ(placeAt(scene, 1.0), glm::dvec3(1, 0, 0));
    EXPECT_NEAR(placeAt(scene, 1.5).x, 2.5625, 1e-12);
    EXPECT_NEAR(placeAt(scene, 2.0).x, 0.5 * 1 + 2 * 0.125 * 3 + 0.5 * 5 + 2 * -0.125 * -1, 1e-12);
    EXPECT_EQ(placeAt(scene, 3.0), glm::dvec3(5, 0, 0));
}

TEST(Animation, RotationsTakeTheShorterWayAtEvenSpeed) {
    // The node turns about +Z by 120 degrees. The negative quaternion is the same rotation.
    const float s = std::sin(glm::radians(60.0F)), c = std::cos(glm::radians(60.0F));
    for (const float sign : {1.0F, -1.0F}) {
        const Scene scene = moved("rotation", {0, 1}, {0, 0, 0, 1, 0, 0, sign * s, sign * c});
        for (const double t : {0.0, 0.25, 0.5, 1.0}) {
            const double angle = glm::radians(120.0 * t);
            expectNear(at(scene, t)[0], {std::cos(angle), std::sin(angle), 0},
                       "x axis at " + std::to_string(t));
        }
    }
}

TEST(Animation, ACubicSplineOfRotationsIsNormalised) {
    // Without tangents the value half way is the mean of the two keys, which is shorter than 1.
    const Scene scene =
        moved("rotation", {0, 1},
              {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, half, half, 0, 0, 0, 0}, "CUBICSPLINE");
    expectNear(at(scene, 0.5)[0], {half, half, 0}, "45 degrees about z");
    EXPECT_NEAR(glm::determinant(at(scene, 0.5)), 1.0, 1e-9);
}

// Exporters write a cut like this.
TEST(Animation, TwoKeysAtOneTimeAreAJump) {
    const Scene scene = moved("translation", {0, 1, 1, 2}, {0, 0, 0, 4, 0, 0, 7, 0, 0, 8, 0, 0});
    EXPECT_TRUE(hasWarning(scene, "two keys at one time"));
    EXPECT_EQ(placeAt(scene, 0.5).x, 2.0);
    EXPECT_EQ(placeAt(scene, 1.0).x, 7.0);
    EXPECT_EQ(placeAt(scene, 1.5).x, 7.5);
    const Scene atTheEnd = moved("translation", {0, 1, 1}, {0, 0, 0, 4, 0, 0, 7, 0, 0});
    EXPECT_EQ(placeAt(atTheEnd, 1.0).x, 7.0);
}

TEST(Animation, OneKeyIsAConstant) {
    const Scene linear = moved("translation", {2}, {1, 2, 3});
    for (const double t : {0.0, 2.0, 5.0})
        EXPECT_EQ(placeAt(linear, t), glm::dvec3(1, 2, 3)) << t;
    const Scene spline = moved("translation", {2}, {9, 9, 9, 1, 2, 3, 9, 9, 9}, "CUBICSPLINE");
    for (const double t : {0.0, 2.0, 5.0})
        EXPECT_EQ(placeAt(spline, t), glm::dvec3(1, 2, 3)) << t;
}

// A mesh hangs on a matrix, on a moved node and on a turned root. Another mesh hangs on the root.
TEST(Animation, MovesTheChildrenOfANodeAndNothingElse) {
    GltfBuilder builder;
    const int mesh = builder.triangle();
    builder.triangle();
    const int crate = builder.add(
        "nodes", {{"children", {mesh}}, {"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 1, 0, 1}}});
    const int cart =
        builder.add("nodes", {{"children", {crate}}, {"translation", {9, 9, 9}}, {"scale", {1, 1, 3}}});
    const int root = builder.add("nodes", {{"children", {cart, 1}}, {"rotation", {0, 0, half, half}}});
    builder.document["scenes"][0]["nodes"] = {root};
    builder.animate(cart, "translation", {0, 1}, {0, 0, 0, 4, 0, 0});
    const Scene scene = load(builder);
    ASSERT_EQ(scene.instances.size(), 2U);
    EXPECT_TRUE(scene.instances[0].moves());
    EXPECT_FALSE(scene.instances[1].moves());
    ASSERT_EQ(scene.animation.nodes.size(), 3U);  // cart, crate, mesh
    // The rest pose is that of the file.
    expectNear(scene.instances[0].worldFromObject[3], {-10, 9, 9}, "rest");
    // The place is 4 along x and 1 along y, turned by a quarter about z. The scale is 2, and 6 along z.
    const glm::dmat4 world = at(scene, 1.0);
    expectNear(world[3], {-1, 4, 0}, "place");
    expectNear(world[0], {0, 2, 0}, "x");
    expectNear(world[1], {-2, 0, 0}, "y");
    expectNear(world[2], {0, 0, 6}, "z");
}

TEST(Animation, MovesCamerasAndLights) {
    GltfBuilder builder;
    builder.triangle();
    builder.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}});
    builder.document["extensionsUsed"] = {"KHR_lights_punctual"};
    builder.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "directional"}}};
    const int camera = builder.node({{"camera", 0}, {"scale", {2, 2, 2}}});
    const int sun = builder.node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    builder.animate(camera, "translation", {0, 1}, {0, 0, 5, 2, 0, 5});
    builder.animate(sun, "rotation", {0, 1}, {0, 0, 0, 1, half, 0, 0, half});
    builder.animate(sun, "scale", {0, 1, 2}, {1, 1, 1, 1, 1, 1, 0, 0, 0});
    const Scene scene = load(builder);
    const Pose pose = poseAt(scene.animation, 1.0);
    const Camera moved = posed(chooseCamera(scene, ""), pose);
    EXPECT_EQ(moved.worldFromCamera, glm::translate(glm::dmat4(1.0), glm::dvec3(2, 0, 5))) << "no scale";
    expectNear(posed(chooseLight(scene), pose).directionToLight, {0, -1, 0}, "under the horizon");
    // A light that is scaled to zero keeps its direction at rest.
    EXPECT_EQ(posed(chooseLight(scene), poseAt(scene.animation, 2.0)).directionToLight, glm::dvec3(0, 0, 1));
    EXPECT_FALSE(scene.instances.at(0).moves());
    // A camera that is not of the scene does not move.
    const Camera fixed = lookAt({0, 0, 5}, {0, 0, 0}, 40);
    EXPECT_EQ(posed(fixed, pose).worldFromCamera, fixed.worldFromCamera);
}

TEST(Animation, BoundsHoldEveryPoseButNoMoreThanHalfASideBeyondRest) {
    // A triangle of side 1 beside one that makes the scene 2 wide: at most 1 beyond it.
    const auto boundsWith = [](const std::vector<float>& target) {
        GltfBuilder builder;
        builder.triangle();
        const int node = builder.triangle();
        builder.document["nodes"][1]["translation"] = {1, 0, 0};
        builder.animate(node, "translation", {0, 1}, {1, 0, 0, target[0], target[1], target[2]});
        return load(builder).boundsWorld;
    };
    EXPECT_EQ(boundsWith({1, 0, 0}).max, glm::dvec3(2, 1, 0));
    EXPECT_EQ(boundsWith({1.5F, 0.5F, 0}).max, glm::dvec3(2.5, 1.5, 0));
    EXPECT_EQ(boundsWith({1.5F, 0.5F, 0}).min, glm::dvec3(0));
    EXPECT_EQ(boundsWith({1e6F, -50, 0}).max, glm::dvec3(3, 1, 0));
    EXPECT_EQ(boundsWith({1e6F, -50, 0}).min, glm::dvec3(0, -1, 0));
    EXPECT_EQ(boundsWith({1e17F, 0, 0}).max, glm::dvec3(3, 1, 0));
    expectMentions(errorOf([&] { boundsWith({1e20F, 0, 0}); }), {"moves a mesh beyond 1e18"});
}

// The node swings farther to the side than at either key.
TEST(Animation, BoundsHoldPosesBetweenTheKeys) {
    const Scene scene = moved("rotation", {0, 1}, {0, 0, 0, 1, 0, 0, half, half});
    // The corner (1, 0, 0) swings to (0, 1, 0), and (0, 1, 0) to (-1, 0, 0).
    EXPECT_NEAR(scene.boundsWorld.min.x, -0.5, 1e-6) << "half of the largest side at rest";
    EXPECT_NEAR(scene.boundsWorld.max.y, 1.0, 1e-6);
}

TEST(Animation, AnotherOneIsChosenByNameOrIndexAndTheRestIsNamed) {
    GltfBuilder builder;
    const int node = builder.triangle();
    const int other = builder.triangle();
    builder.animate(node, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}, "LINEAR", 0);
    builder.animate(other, "translation", {0, 1}, {0, 0, 0, 0, 2, 0}, "LINEAR", 1);
    builder.document["animations"][0]["name"] = "walk";
    builder.document["animations"][1]["name"] = "wave";
    const auto loadWith = [&](const std::string& animation) {
        const Bytes file = builder.glb();
        return loadGltf("test.glb", [&](const std::string&) { return file; }, {.animation = animation});
    };
    for (const char* first : {"", "0", "walk"}) {
        const Scene scene = loadWith(first);
        EXPECT_EQ(scene.animation.name, "walk") << first;
        EXPECT_TRUE(scene.instances.at(0).moves());
        EXPECT_FALSE(scene.instances.at(1).moves());
        EXPECT_TRUE(hasWarning(scene, "not played (--animation): 1 (wave)")) << first;
    }
    for (const char* second : {"1", "wave"}) {
        const Scene scene = loadWith(second);
        EXPECT_EQ(scene.animation.name, "wave") << second;
        EXPECT_FALSE(scene.instances.at(0).moves());
        EXPECT_TRUE(scene.instances.at(1).moves());
        EXPECT_TRUE(hasWarning(scene, "not played (--animation): 0 (walk)")) << second;
    }
    for (const char* none : {"2", "run", "-1"})
        expectMentions(errorOf([&] { loadWith(none); }), {"choose one of 0 (walk), 1 (wave)"});
}

TEST(Animation, IgnoredChannelsAreWarnedOf) {
    GltfBuilder builder;
    const int node = builder.triangle();
    builder.animate(node, "translation", {0, 1}, {0, 0, 0, 1, 0, 0});
    json& channels = builder.document["animations"][0]["channels"];
    channels.push_back({{"sampler", 0}, {"target", {{"node", node}, {"path", "weights"}}}});
    channels.push_back({{"sampler", 0}, {"target", {{"path", "translation"}}}});
    channels.push_back({{"sampler", 0}, {"target", {{"path", "pointer"}}}});
    const Scene scene = load(builder);
    EXPECT_EQ(scene.animation.channels.size(), 1U);
    for (const char* word : {"weights", "without a node", "\"pointer\""})
        EXPECT_TRUE(hasWarning(scene, word)) << word;
}

TEST(Animation, OfNodesOutsideTheSceneIsIgnored) {
    GltfBuilder builder;
    builder.triangle();
    builder.animate(builder.add("nodes", {{"name", "elsewhere"}}), "translation", {0, 1}, {0, 0, 0, 1, 0, 0});
    const Scene scene = load(builder);
    EXPECT_TRUE(scene.animation.channels.empty());
    EXPECT_FALSE(scene.instances.at(0).moves());
}

// Errors of the JSON around the keys are in gltf_errors_test.cpp.
TEST(Animation, KeysThatAreNotValidAreOneErrorThatNamesTheChannel) {
    struct Keys {
        const char* part;  // of the message
        std::vector<float> times, values;
    };
    const std::vector<float> two{0, 0, 0, 1, 0, 0, half, half};
    const Keys wrong[] = {
        {"unsorted keys", {1, 0}, two},
        {"negative or not a number", {-1, 0}, two},
        {"negative or not a number", {0, noNumber}, two},
        {"negative or not a number", {0, std::numeric_limits<float>::infinity()}, two},
        {"2 values for 3 keys, where 3 are needed", {0, 1, 2}, two},
        {"2 values for 1 keys", {0}, two},
        {"zero length for key 1", {0, 1}, {0, 0, 0, 1, 0, 0, 0, 0}},
        {"not a usable number", {0, 1}, {0, 0, 0, 1, 0, noNumber, 0, 1}},
        {"not a usable number", {0, 1}, {0, 0, 0, 1, 0, 3e38F, 0, 1}},
    };
    for (const Keys& keys : wrong) {
        GltfBuilder builder;
        builder.animate(builder.triangle(), "rotation", keys.times, keys.values);
        expectMentions(loadError(builder, {.animation = "0"}),
                       {keys.part, "test.glb", "animation 0, channel 0"});
    }
}

}  // namespace
}  // namespace vct::test
