#include "scene/parts.h"

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace vct::test {
namespace {

void expectSides(const Part& part, double a, double b, double c, double within = 1e-6) {
    EXPECT_NEAR(part.sides[0], a, within);
    EXPECT_NEAR(part.sides[1], b, within);
    EXPECT_NEAR(part.sides[2], c, within);
}

TEST(Parts, PiecesOfOneMeshThatDoNotTouchAreApart) {
    Scene scene = emptyScene();
    addBox(scene, {1.0, 1.0, 1.0});
    Mesh& mesh = scene.meshes[0];
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        Vertex vertex = mesh.vertices[i];
        vertex.position += glm::vec3(5, 0, 0);
        mesh.vertices.push_back(vertex);
    }
    const std::size_t indices = mesh.indices.size();
    for (std::size_t i = 0; i < indices; ++i)
        mesh.indices.push_back(mesh.indices[i] + count);
    const std::vector<Part> parts = connectedParts(scene);
    ASSERT_EQ(parts.size(), 2U);
    for (const Part& part : parts)
        expectSides(part, 1, 1, 1);
}

TEST(Parts, ASheetHasNoShortestSideAndWhatHasNoAreaIsLeftOut) {
    Scene scene = emptyScene();
    addQuad(scene, {0, 0, 0}, {0, 0.5, 0}, {0, 0, 2});
    addQuad(scene, {0, 0, 0}, {1, 0, 0}, {1, 0, 0});
    const std::vector<Part> parts = connectedParts(scene);
    ASSERT_EQ(parts.size(), 1U);
    expectSides(parts[0], 0.0, 0.5, 2.0);
}

}  // namespace
}  // namespace vct::test
