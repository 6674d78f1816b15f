// KHR_draco_mesh_compression, packed here by the library's own encoder.
#include <gtest/gtest.h>

#ifdef VCT_HAS_DRACO
#include <draco/compression/expert_encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#endif

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "support/errors.h"
#include "support/packed_mesh.h"

namespace vct::test {
namespace {

// A primitive whose accessors have no bytes of their own.
GltfBuilder dracoFile(const Bytes& stream, std::size_t vertices, std::size_t indices) {
    GltfBuilder builder;
    const int view = builder.view(stream.data(), stream.size());
    const auto accessor = [&](std::size_t count, int type, const char* shape) {
        return builder.add("accessors", {{"count", count}, {"componentType", type}, {"type", shape}});
    };
    json primitive = {{"attributes",
                       {{"POSITION", accessor(vertices, float32, "VEC3")},
                        {"NORMAL", accessor(vertices, float32, "VEC3")},
                        {"TEXCOORD_0", accessor(vertices, float32, "VEC2")}}},
                      {"indices", accessor(indices, uint32, "SCALAR")}};
    primitive["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", view}, {"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"TEXCOORD_0", 2}}}};
    builder.node({{"mesh", builder.mesh(primitive)}});
    builder.document["meshes"][0]["name"] = "field";
    builder.document["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    builder.document["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return builder;
}

#ifdef VCT_HAS_DRACO

const BumpyField dracoField(24);
constexpr int dracoBits = 14;  // of positions, which span 4 units

struct DracoOf {
    Bytes stream;
    std::size_t vertices = 0, indices = 0;
    GltfBuilder file() const { return dracoFile(stream, vertices, indices); }
};

DracoOf encodeDraco(const BumpyField& field, int method) {
    draco::TriangleSoupMeshBuilder soup;
    const auto faces = static_cast<int>(field.indices.size() / 3);
    soup.Start(faces);
    const std::vector<float>* values[] = {&field.positions, &field.normals, &field.uvs};
    const draco::GeometryAttribute::Type types[] = {draco::GeometryAttribute::POSITION,
                                                    draco::GeometryAttribute::NORMAL,
                                                    draco::GeometryAttribute::TEX_COORD};
    for (int attribute = 0; attribute < 3; ++attribute) {
        const int width = attribute == 2 ? 2 : 3;
        const int id =
            soup.AddAttribute(types[attribute], static_cast<std::int8_t>(width), draco::DT_FLOAT32);
        for (int face = 0; face < faces; ++face) {
            const auto corner = [&](int i) {
                const std::size_t vertex = field.indices[static_cast<std::size_t>(3 * face + i)];
                return values[attribute]->data() + vertex * static_cast<std::size_t>(width);
            };
            soup.SetAttributeValuesForFace(id, draco::FaceIndex(static_cast<std::uint32_t>(face)), corner(0),
                                           corner(1), corner(2));
        }
    }
    const std::unique_ptr<draco::Mesh> mesh = soup.Finalize();
    draco::ExpertEncoder encoder(*mesh);
    encoder.SetEncodingMethod(method);
    encoder.SetAttributeQuantization(0, dracoBits);
    encoder.SetAttributeQuantization(1, 12);
    encoder.SetAttributeQuantization(2, 14);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
    DracoOf result;
    result.stream.assign(buffer.data(), buffer.data() + buffer.size());
    result.vertices = encoder.num_encoded_points();
    result.indices = 3 * encoder.num_encoded_faces();
    if (result.indices == 0) result = {result.stream, mesh->num_points(), std::size_t{3} * mesh->num_faces()};
    return result;
}

const auto dracoMethods = {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING};

// The corners of a regular field, sorted by their place in it.
std::vector<const Vertex*> cornersByPlace(const Mesh& mesh) {
    std::vector<const Vertex*> corners;
    for (const std::uint32_t index : mesh.indices)
        corners.push_back(&mesh.vertices[index]);
    std::sort(corners.begin(), corners.end(), [](const Vertex* a, const Vertex* b) {
        const auto cell = [](float x) { return std::lround(x * 23); };
        return std::make_pair(cell(a->uv.x), cell(a->uv.y)) < std::make_pair(cell(b->uv.x), cell(b->uv.y));
    });
    return corners;
}

TEST(Draco, UnpacksToThePlainMeshWithinTheQuantisation) {
    const Mesh plain = load(plainField(dracoField)).meshes.at(0);
    for (const int method : dracoMethods) {
        const Scene scene = load(encodeDraco(dracoField, method).file());
        EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.at(0);
        const Mesh& mesh = scene.meshes.at(0);
        ASSERT_EQ(mesh.indices.size(), plain.indices.size());
        const std::vector<const Vertex*> a = cornersByPlace(mesh), b = cornersByPlace(plain);
        const float step = 4.0F / (1 << dracoBits);
        for (std::size_t i = 0; i < a.size(); ++i) {
            const glm::vec3 position = a[i]->position + glm::vec3(mesh.centre);
            ASSERT_LT(glm::length(position - (b[i]->position + glm::vec3(plain.centre))), step) << i;
            ASSERT_LT(glm::length(a[i]->normal - b[i]->normal), 2e-3F) << i;
            ASSERT_LT(glm::length(a[i]->uv - b[i]->uv), 1e-4F) << i;
        }
        // The triangles have the right winding: their normals are close to those of the vertices.
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]].position; };
            const glm::vec3 face = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
            ASSERT_GT(glm::dot(face, mesh.vertices[mesh.indices[i]].normal), 0.0F) << i;
        }
    }
}

TEST(Draco, ErrorsAreNamed) {
    const DracoOf packed = encodeDraco(dracoField, draco::MESH_EDGEBREAKER_ENCODING);
    const auto errorOf = [&](const char* place, json value) {
        GltfBuilder builder = packed.file();
        json& primitive = builder.document["meshes"][0]["primitives"][0];
        primitive[json::json_pointer(place)] = std::move(value);
        return loadError(builder);
    };
    const std::string extension = "/extensions/KHR_draco_mesh_compression";
    const std::string mesh = "mesh 0 (field)";
    expectMentions(errorOf((extension + "/bufferView").c_str(), 7), {"buffer view 7"});
    expectMentions(errorOf((extension + "/attributes").c_str(), nullptr), {mesh, "no attributes"});
    expectMentions(errorOf((extension + "/attributes/NORMAL").c_str(), 9), {mesh, "no attribute 9 (NORMAL)"});
    expectMentions(errorOf((extension + "/attributes/NORMAL").c_str(), 2), {mesh, "2 numbers per element"});
    expectMentions(errorOf((extension + "/attributes").c_str(), {{"NORMAL", 1}}), {mesh, "neither"});
    expectMentions(errorOf("/indices", 99), {"indices accessor out of bounds"});
    expectMentions(loadError(dracoFile(bytesOf("DRACO"), 9, 9)), {mesh, "damaged header"});
    expectMentions(loadError(dracoFile(bytesOf("nothing of that kind"), 9, 9)), {mesh, "damaged header"});
    DracoOf cut = packed;
    cut.stream.resize(cut.stream.size() / 2);
    expectMentions(loadError(cut.file()), {mesh, "buffer view 0", "cannot be unpacked"});
}

// 2^31 triangles are refused before the library allocates their tables.
TEST(Draco, MoreThanTheMemoryHoldsIsRefused) {
    Bytes stream = bytesOf("DRACO");
    stream.insert(stream.end(), {2, 2, 1, 1, 0, 0});
    stream.push_back(0);
    for (int i = 0; i < 2; ++i)
        stream.insert(stream.end(), {0xFF, 0xFF, 0xFF, 0xFF, 0x07});
    stream.resize(200);
    expectMentions(loadError(dracoFile(stream, 9, 9)), {"mesh 0 (field)", "available"});
}

// Damaged streams load or are refused, which the sanitizers check best.
TEST(Draco, DamagedStreamsNeverCrash) {
    std::mt19937 random(11);
    int refused = 0, tried = 0;
    for (const int method : dracoMethods) {
        const DracoOf packed = encodeDraco(BumpyField(9), method);
        for (int i = 0; i < 200; ++i, ++tried) {
            DracoOf damaged = packed;
            for (int bytes = 0; bytes < 1 + i % 4; ++bytes)
                damaged.stream[random() % damaged.stream.size()] = static_cast<unsigned char>(random());
            const std::string error = loadError(damaged.file());
            if (error.empty()) continue;
            ++refused;
            expectMentions(error, {"test.glb"});
        }
    }
    EXPECT_GT(refused, 20);
    EXPECT_LT(refused, tried);
}

#else

TEST(Draco, IsRefusedByTheNameOfTheLibrary) {
    GltfBuilder builder = dracoFile(bytesOf("DRACO"), 3, 3);
    expectMentions(loadError(builder), {"test.glb", "mesh 0 (field)", "Draco", "VCT_DRACO"});
    // A file that also holds the plain mesh is read without the library.
    GltfBuilder plain = plainField(BumpyField(3));
    plain.document["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", 0}};
    EXPECT_EQ(load(plain).triangleCount(), 8U);
}

#endif

}  // namespace
}  // namespace vct::test
