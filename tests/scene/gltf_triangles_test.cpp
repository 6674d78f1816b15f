#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "support/gltf_builder.h"

namespace vct::test {
namespace {

// A square in z = 0 as two triangles, (0,0) (1,0) (1,1) (0,1) counter-clockwise.
const std::vector<float> squareList{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0};
const std::vector<float> squareFan{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
// A strip with the diagonal of the list and the fan: (1,0) (1,1) (0,0) (0,1).
const std::vector<float> squareStrip{1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 1, 0};
const std::vector<float> fourUps{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};

Mesh loadOne(GltfBuilder& builder, json primitive) {
    builder.node({{"mesh", builder.mesh(std::move(primitive))}});
    const Scene scene = load(builder);
    EXPECT_EQ(scene.meshes.size(), 1U);
    return scene.meshes.at(0);
}

Mesh loadPositions(const std::vector<float>& positions, int mode) {
    GltfBuilder builder;
    return loadOne(builder, {{"attributes", {{"POSITION", builder.floats(positions)}}}, {"mode", mode}});
}

TEST(GltfTriangles, EveryModeGivesTheSameTriangles) {
    const auto expected = triangleSoup(loadPositions(squareList, 4));
    ASSERT_EQ(expected.size(), 6U);
    EXPECT_EQ(triangleSoup(loadPositions(squareStrip, 5)), expected);
    EXPECT_EQ(triangleSoup(loadPositions(squareFan, 6)), expected);
}

template <class Index>
std::vector<glm::vec3> indexedSquare(int componentType) {
    GltfBuilder builder;
    const int indices = builder.accessor(std::vector<Index>{0, 1, 2, 0, 2, 3}, componentType, "SCALAR");
    return triangleSoup(loadOne(
        builder,
        {{"attributes", {{"POSITION", builder.floats(squareFan)}, {"NORMAL", builder.floats(fourUps)}}},
         {"indices", indices}}));
}

TEST(GltfTriangles, EveryIndexTypeGivesTheSameTriangles) {
    const auto expected = triangleSoup(loadPositions(squareList, 4));
    EXPECT_EQ(indexedSquare<std::uint8_t>(uint8), expected);
    EXPECT_EQ(indexedSquare<std::uint16_t>(uint16), expected);
    EXPECT_EQ(indexedSquare<std::uint32_t>(uint32), expected);
}

TEST(GltfTriangles, PointsAndLinesAreLeftOutWithAWarning) {
    for (const int mode : {0, 1, 2, 3}) {
        GltfBuilder builder;
        builder.triangle();
        const int mesh =
            builder.mesh({{"attributes", {{"POSITION", builder.floats(squareList)}}}, {"mode", mode}});
        builder.node({{"mesh", mesh}});
        const Scene scene = load(builder);
        EXPECT_EQ(scene.triangleCount(), 1U);
        EXPECT_TRUE(hasWarning(scene, "points and lines"));
    }
}

TEST(GltfTriangles, WithoutNormalsTheyAreFlatAndVerticesAreNotShared) {
    GltfBuilder builder;
    // Two faces at a right angle that share an edge.
    const int positions = builder.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -2});
    const int indices = builder.accessor(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, uint16, "SCALAR");
    const Mesh mesh = loadOne(builder, {{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
    ASSERT_EQ(mesh.vertices.size(), 6U);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(mesh.vertices[mesh.indices[i]].normal, glm::vec3(0, 0, 1));
        EXPECT_EQ(mesh.vertices[mesh.indices[3 + i]].normal, glm::vec3(1, 0, 0) * -1.0F);
    }
}

TEST(GltfTriangles, NormalsAreMadeUnitAndBadOnesReplaced) {
    constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
    GltfBuilder builder;
    const int positions = builder.floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int normals = builder.floats({0, 0, 0, notANumber, 0, 1, 0, 3, 4});
    builder.node({{"mesh", builder.mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}})}});
    const Scene scene = load(builder);
    const Mesh& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.vertices[0].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.vertices[1].normal, glm::vec3(0, 0, 1));
    EXPECT_NEAR(glm::distance(mesh.vertices[2].normal, glm::vec3(0.0F, 0.6F, 0.8F)), 0.0F, 1e-6F);
    EXPECT_TRUE(hasWarning(scene, "normals"));
}

TEST(GltfTriangles, StridedAndQuantizedAttributes) {
    GltfBuilder builder;
    // Positions of 12 bytes and normals of 3 in records of 16.
    std::vector<unsigned char> records(3 * 16);
    const float positions[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (std::size_t i = 0; i < 3; ++i) {
        std::memcpy(&records[i * 16], positions[i], 12);
        records[i * 16 + 14] = 127;  // z as a normalized signed byte
    }
    const int view = builder.view(records.data(), records.size());
    builder.document["bufferViews"][0]["byteStride"] = 16;
    const int position = builder.accessorOf(view, 3, float32, "VEC3");
    const int normal = builder.accessorOf(view, 3, int8, "VEC3", true);
    builder.document["accessors"][1]["byteOffset"] = 12;
    const int uv =
        builder.accessor(std::vector<std::uint16_t>{0, 0, 65535, 0, 0, 65535}, uint16, "VEC2", true);
    builder.document["extensionsRequired"] = {"KHR_mesh_quantization"};
    builder.document["extensionsUsed"] = {"KHR_mesh_quantization"};
    const Mesh mesh =
        loadOne(builder, {{"attributes", {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}}}});
    EXPECT_EQ(triangleSoup(mesh).at(1), glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.vertices[2].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.vertices[1].uv, glm::vec2(1, 0));
    EXPECT_EQ(mesh.vertices[2].uv, glm::vec2(0, 1));
}

TEST(GltfTriangles, SparseValuesReplaceThoseBelow) {
    for (const bool hasBase : {true, false}) {
        GltfBuilder builder;
        const int positions = builder.floats({0, 0, 0, 9, 9, 9, 0, 0, 0});
        const std::uint8_t where[] = {1, 2};
        const float values[] = {1, 0, 0, 0, 1, 0};
        json& accessor = builder.document["accessors"][0];
        const int whereView = builder.view(where, sizeof where);
        const int valueView = builder.view(values, sizeof values);
        accessor["sparse"] = {{"count", 2},
                              {"indices", {{"bufferView", whereView}, {"componentType", uint8}}},
                              {"values", {{"bufferView", valueView}}}};
        if (!hasBase) accessor.erase("bufferView");
        const Mesh mesh = loadOne(builder, {{"attributes", {{"POSITION", positions}}}});
        EXPECT_EQ(triangleSoup(mesh), triangleSoup(loadPositions({0, 0, 0, 1, 0, 0, 0, 1, 0}, 4)));
    }
}

TEST(GltfTriangles, VerticesKeepTheirPrecisionFarFromTheOrigin) {
    const Mesh mesh = loadPositions({1e6F, 0, 0, 1e6F + 0.0625F, 0, 0, 1e6F, 0.0625F, 0}, 4);
    EXPECT_EQ(mesh.centre, glm::dvec3(1e6 + 0.03125, 0.03125, 0));
    EXPECT_EQ(mesh.vertices[0].position, glm::vec3(-0.03125F, -0.03125F, 0));
    EXPECT_EQ(mesh.vertices[1].position, glm::vec3(0.03125F, -0.03125F, 0));
}

}  // namespace
}  // namespace vct::test
