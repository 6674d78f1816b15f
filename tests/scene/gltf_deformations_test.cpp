#include <gtest/gtest.h>

#include <cmath>

#include "scene/deformation.h"
#include "support/errors.h"
#include "support/gltf_builder.h"
#include "support/moving_scenes.h"

namespace vct::test {
namespace {

const Mesh& deformingMesh(const Scene& scene, int which) {
    for (const Instance& instance : scene.instances)
        if (instance.deforms && which-- == 0) return scene.meshes[static_cast<std::size_t>(instance.mesh)];
    throw std::out_of_range("no such mesh");
}

glm::dvec3 world(const Mesh& mesh, std::size_t vertex) {
    return mesh.centre + glm::dvec3(mesh.vertices[vertex].position);
}

void expectNear(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance = 1e-5) {
    EXPECT_LE(glm::length(actual - expected), tolerance)
        << actual.x << " " << actual.y << " " << actual.z << ", expected " << expected.x << " " << expected.y
        << " " << expected.z;
}

TEST(Deformations, AVertexBetweenTwoJointsGoesHalfTheWay) {
    const Scene scene = load(twoThatDeform());
    const Mesh& column = deformingMesh(scene, 0);
    const Pose pose = poseAt(scene.animation, 1.0);
    const DeformationState state = stateOf(*column.deformation, &pose);
    // At one second the foot is at (-.2, 0, -.15), and from the knee on all turns by 45 degrees about z.
    const double c = std::sqrt(0.5);
    const glm::dvec3 foot(-0.2, 0.0, -0.15), knee = foot + glm::dvec3(0, 0.8, 0);
    const auto vertex = [&](std::size_t ring) {
        return deformedVertex(*column.deformation, state, 8 * ring);
    };
    expectNear(vertex(0).positionWorld, foot + glm::dvec3(0.25, 0, 0));
    const glm::dvec3 turned(c * 0.25, c * 0.25, 0);
    expectNear(vertex(4).positionWorld, knee + turned);
    expectNear(vertex(4).normalWorld, {c, c, 0});
    // A quarter up, the foot and the knee have a half each.
    const glm::dvec3 byFoot = foot + glm::dvec3(0.25, 0.4, 0);
    const glm::dvec3 byKnee = knee + turned + glm::dvec3(c * 0.4, -c * 0.4, 0);
    expectNear(vertex(2).positionWorld, 0.5 * (byFoot + byKnee));
}

TEST(Deformations, MorphTargetsAddUpByTheirWeights) {
    const Scene scene = load(twoThatDeform());
    const Mesh& box = deformingMesh(scene, 1);
    const Pose pose = poseAt(scene.animation, 1.5);
    ASSERT_EQ(pose.morphWeights.size(), 1U);
    EXPECT_EQ(pose.morphWeights[0], (std::vector<float>{0.75F, 0.5F}));
    const DeformationState state = stateOf(*box.deformation, &pose);
    for (std::size_t i = 0; i < box.vertices.size(); ++i) {
        const glm::dvec3 rest = world(box, i) - glm::dvec3(1, 0.5, -0.8);
        const bool top = rest.y > 0.0;
        const glm::dvec3 moved(top ? std::copysign(0.3, rest.x) : 0.0, top ? 0.225 : 0.0, top ? 0.25 : 0.0);
        expectNear(deformedVertex(*box.deformation, state, i).positionWorld, world(box, i) + moved);
    }
}

// The weights of all targets of a key stand between their in-tangents and out-tangents (glTF 2.0, appendix
// C.5).
TEST(Deformations, WeightsFollowSplines) {
    GltfBuilder builder = twoThatDeform();
    const int box = static_cast<int>(builder.document["nodes"].size()) - 1;
    builder.document.erase("animations");
    builder.animate(box, "weights", {0, 1},
                    {0, 0, 0, 2, 0, 3,    // in-tangents, values, out-tangents of the first key
                     0, 0, 1, -1, 0, 0},  // and of the second
                    "CUBICSPLINE");
    const Scene scene = load(builder);
    const std::vector<float> weights = poseAt(scene.animation, 0.5).morphWeights.at(0);
    EXPECT_NEAR(weights.at(0), 0.5, 1e-6);
    EXPECT_NEAR(weights.at(1), 0.5 * 2 + 0.5 * -1 + 0.125 * 3, 1e-6);
}

TEST(Deformations, BoxesAndBoundsHoldEveryVertexAtEveryTime) {
    const Scene scene = load(twoThatDeform());
    for (const int which : {0, 1}) {
        const Deformation& deformation = *deformingMesh(scene, which).deformation;
        const DeformationBoxes boxes(deformation);
        for (double seconds = 0.0; seconds <= 2.0; seconds += 0.25) {
            const Pose pose = poseAt(scene.animation, seconds);
            const DeformationState state = stateOf(deformation, &pose);
            const Bounds box = boxes.around(state, glm::dmat4(1.0));
            for (std::size_t i = 0; i < deformation.positions.size(); ++i) {
                const glm::dvec3 p = deformedVertex(deformation, state, i).positionWorld;
                EXPECT_TRUE(glm::all(glm::lessThanEqual(box.min - 1e-6, p)) &&
                            glm::all(glm::lessThanEqual(p, box.max + 1e-6)));
                EXPECT_TRUE(glm::all(glm::lessThanEqual(scene.boundsWorld.min - 1e-3, p)) &&
                            glm::all(glm::lessThanEqual(p, scene.boundsWorld.max + 1e-3)))
                    << seconds;
            }
        }
    }
}

// Exporters write anything there.
TEST(Deformations, TheMatrixOfAJointThatNoVertexFollowsIsIgnored) {
    const auto withGarbage = [](std::size_t joint) {
        GltfBuilder b = twoThatDeform();
        json& skin = b.document["skins"][0];
        skin["joints"].push_back(skin["joints"][2]);
        std::vector<float> matrices;
        for (std::size_t i = 0; i < 4; ++i) {
            const float value = i == joint ? std::nanf("") : 1.0F;
            const float height = 0.8F * static_cast<float>(i);
            matrices.insert(matrices.end(),
                            {value, 0, 0, 0, 0, value, 0, 0, 0, 0, value, 0, 0, -height, 0, 1});
        }
        skin["inverseBindMatrices"] = b.floats(matrices, "MAT4");
        return b;
    };
    const Scene plain = load(twoThatDeform()), scene = load(withGarbage(3));
    EXPECT_EQ(scene.boundsWorld.min, plain.boundsWorld.min);
    EXPECT_EQ(scene.boundsWorld.max, plain.boundsWorld.max);
    EXPECT_EQ(triangleSoup(deformingMesh(scene, 0)), triangleSoup(deformingMesh(plain, 0)));
    expectMentions(loadError(withGarbage(1)), {"skin 0", "inverse bind matrix", "joint 1", "usable numbers"});
}

// The joints place it.
TEST(Deformations, ASkinnedNodeScaledToZeroIsDrawnWithoutAWarning) {
    GltfBuilder builder = twoThatDeform();
    const Scene plain = load(builder);
    for (json& node : builder.document["nodes"])
        if (node.contains("skin")) node["scale"] = {0, 0, 0};
    const Scene scene = load(builder);
    EXPECT_EQ(triangleSoup(deformingMesh(scene, 0)), triangleSoup(deformingMesh(plain, 0)));
    EXPECT_EQ(scene.warnings, plain.warnings);
}

TEST(Deformations, DamagedOnesAreNamed) {
    const auto changed = [](auto&& change) {
        GltfBuilder builder = twoThatDeform();
        change(builder);
        return loadError(builder);
    };
    const auto has = [](const std::string& text, const char* part) { expectMentions(text, {part}); };
    has(changed([](GltfBuilder& b) { b.document["skins"][0]["joints"].erase(2); }), "follow joint 2 of 2");
    has(changed([](GltfBuilder& b) {
            b.document["skins"][0]["inverseBindMatrices"] =
                b.floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, "MAT4");
        }),
        "are only 1 for 3 joints");
    has(changed([](GltfBuilder& b) {
            json& primitive = b.document["meshes"][1]["primitives"][0];
            primitive["attributes"]["WEIGHTS_0"] = b.floats({1, 0, 0, 0}, "VEC4");
        }),
        "WEIGHTS_0 has 1 elements for 72 vertices");
    has(changed([](GltfBuilder& b) {
            json& primitive = b.document["meshes"][2]["primitives"][0];
            primitive["targets"][0]["POSITION"] = b.floats({1, 0, 0});
        }),
        "morph target has 1 elements for 8 vertices");
    // With weights that do not fit their keys the scene is drawn, but does not play.
    GltfBuilder odd = twoThatDeform();
    const int box = static_cast<int>(odd.document["nodes"].size()) - 1;
    odd.document.erase("animations");
    odd.animate(box, "weights", {0, 1}, {0, 0, 1});
    EXPECT_TRUE(hasWarning(load(odd), "has 3 values for 2 keys of 2 weights"));
}

}  // namespace
}  // namespace vct::test
