#include "scene/parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "support/scenes.h"

namespace vct::test {
namespace {

void expectSides(const Part& part, double a, double b, double c, double within = 1e-6) {
    EXPECT_NEAR(part.sides[0], a, within);
    EXPECT_NEAR(part.sides[1], b, within);
    EXPECT_NEAR(part.sides[2], c, within);
}

TEST(Parts, ABoxIsOnePartThoughItsFacesShareNoVertex) {
    Scene scene = emptyScene();
    addBox(scene, {2.0, 0.12, 0.16});
    const std::vector<Part> parts = connectedParts(scene);
    ASSERT_EQ(parts.size(), 1U);
    expectSides(parts[0], 0.12, 0.16, 2.0);
    EXPECT_NEAR(parts[0].area, 2.0 * (2.0 * 0.12 + 2.0 * 0.16 + 0.12 * 0.16), 1e-6);
}

TEST(Parts, ABoxTurnedInsideItsObjectHasItsOwnSides) {
    Scene scene = emptyScene();
    addBox(scene, {2.0, 0.1, 0.3});
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.6, glm::dvec3(3, 1, 2));
    for (Vertex& vertex : scene.meshes[0].vertices)
        vertex.position = glm::vec3(turn * glm::dvec4(glm::dvec3(vertex.position), 1.0));
    expectSides(connectedParts(scene).at(0), 0.1, 0.3, 2.0, 1e-5);
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
