// EXT_meshopt_compression, packed here by the library's own encoder.
#include <gtest/gtest.h>

#ifdef VCT_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

#include <random>

#include "core/error.h"
#include "support/errors.h"
#include "support/packed_mesh.h"

namespace vct::test {
namespace {

#ifdef VCT_HAS_MESHOPT

const BumpyField meshoptField(24);

// Appends a stream, and a view of what it unpacks to in buffer 1, which has no bytes.
int packedView(GltfBuilder& builder, const Bytes& stream, std::size_t count, std::size_t stride,
               const std::string& mode, const std::string& filter = "NONE",
               const char* extension = "EXT_meshopt_compression") {
    const int source = builder.view(stream.data(), stream.size());
    const json place = builder.document["bufferViews"][static_cast<std::size_t>(source)];
    json view = {{"buffer", 1}, {"byteLength", count * stride}};
    if (mode == "ATTRIBUTES") view["byteStride"] = stride;
    view["extensions"][extension] = {{"buffer", 0},
                                     {"byteOffset", place.value("byteOffset", 0)},
                                     {"byteLength", stream.size()},
                                     {"byteStride", stride},
                                     {"count", count},
                                     {"mode", mode},
                                     {"filter", filter}};
    return builder.add("bufferViews", view);
}

Bytes encodeAttributes(const void* values, std::size_t count, std::size_t stride) {
    Bytes stream(meshopt_encodeVertexBufferBound(count, stride));
    stream.resize(meshopt_encodeVertexBuffer(stream.data(), stream.size(), values, count, stride));
    return stream;
}

Bytes encodeIndices(const std::vector<std::uint32_t>& indices, bool triangles) {
    Bytes stream(4096 + indices.size() * 8);
    const std::size_t size =
        triangles ? meshopt_encodeIndexBuffer(stream.data(), stream.size(), indices.data(), indices.size())
                  : meshopt_encodeIndexSequence(stream.data(), stream.size(), indices.data(), indices.size());
    stream.resize(size);
    return stream;
}

// A .glb whose second buffer is the one that views unpack to.
Bytes withFallback(GltfBuilder builder, json fallback) {
    builder.document["buffers"] = {{{"byteLength", builder.binary.size()}}, std::move(fallback)};
    return builder.glb();
}

json emptyFallback(const char* extension = "EXT_meshopt_compression") {
    return {{"byteLength", 1 << 20}, {"extensions", {{extension, {{"fallback", true}}}}}};
}

// Normals and texture coordinates are filtered.
GltfBuilder packedField(bool triangles, const char* extension = "EXT_meshopt_compression") {
    const BumpyField& field = meshoptField;
    const std::size_t n = field.vertexCount();
    GltfBuilder builder;
    const int positions = packedView(builder, encodeAttributes(field.positions.data(), n, 12), n, 12,
                                     "ATTRIBUTES", "NONE", extension);
    std::vector<std::uint8_t> octahedral(8 * n);
    std::vector<float> four;
    for (std::size_t i = 0; i < n; ++i)
        four.insert(four.end(),
                    {field.normals[3 * i], field.normals[3 * i + 1], field.normals[3 * i + 2], 0});
    meshopt_encodeFilterOct(octahedral.data(), n, 8, 16, four.data());
    const int normals = packedView(builder, encodeAttributes(octahedral.data(), n, 8), n, 8, "ATTRIBUTES",
                                   "OCTAHEDRAL", extension);
    std::vector<std::uint32_t> exponential(2 * n);
    meshopt_encodeFilterExp(exponential.data(), n, 8, 20, field.uvs.data());
    const int uvs = packedView(builder, encodeAttributes(exponential.data(), n, 8), n, 8, "ATTRIBUTES",
                               "EXPONENTIAL", extension);
    const int indices = packedView(builder, encodeIndices(field.indices, triangles), field.indices.size(), 4,
                                   triangles ? "TRIANGLES" : "INDICES", "NONE", extension);
    builder.document["extensionsUsed"] = {extension, "KHR_mesh_quantization"};
    builder.node(
        {{"mesh",
          builder.mesh({{"attributes",
                         {{"POSITION", builder.accessorOf(positions, n, float32, "VEC3")},
                          {"NORMAL", builder.accessorOf(normals, n, int16, "VEC3", true)},
                          {"TEXCOORD_0", builder.accessorOf(uvs, n, float32, "VEC2")}}},
                        {"indices", builder.accessorOf(indices, field.indices.size(), uint32, "SCALAR")}})}});
    return builder;
}

TEST(Meshopt, UnpacksToThePlainMesh) {
    const Mesh plain = load(plainField(meshoptField)).meshes.at(0);
    for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        for (const bool triangles : {true, false}) {
            GltfBuilder packed = packedField(triangles, extension);
            packed.document["extensionsRequired"] = packed.document["extensionsUsed"];
            const Scene scene = load(withFallback(packed, emptyFallback(extension)));
            EXPECT_TRUE(scene.warnings.empty());
            const Mesh& mesh = scene.meshes.at(0);
            ASSERT_EQ(mesh.vertices.size(), plain.vertices.size());
            EXPECT_EQ(triangleSoup(mesh), triangleSoup(plain)) << "positions are not quantised";
            for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
                const Vertex &a = mesh.vertices[i], &b = plain.vertices[i];
                ASSERT_LT(glm::length(a.normal - b.normal), 2e-4F) << i;
                ASSERT_LT(glm::length(a.uv - b.uv), 2e-5F) << i;
            }
        }
    }
}

TEST(Meshopt, QuaternionsAreUnpacked) {
    const std::vector<float> rotations{0, 0, 0, 1, 0.5F, 0.5F, 0.5F, 0.5F, 0, 0.6F, 0, 0.8F, 0, 0, 0, 1};
    std::vector<std::int16_t> filtered(16);
    meshopt_encodeFilterQuat(filtered.data(), 4, 8, 16, rotations.data());
    GltfBuilder builder;
    builder.triangle();
    const int view =
        packedView(builder, encodeAttributes(filtered.data(), 4, 8), 4, 8, "ATTRIBUTES", "QUATERNION");
    builder.document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["ROTATION"] =
        builder.accessorOf(view, 4, int16, "VEC4", true);
    const Scene scene = load(withFallback(builder, emptyFallback()));
    ASSERT_EQ(scene.instances.size(), 4U);
    EXPECT_NEAR(scene.instances[1].worldFromObject[0][1], 1.0, 1e-3) << "x goes to y";
    EXPECT_NEAR(scene.instances[2].worldFromObject[0][2], -0.96, 1e-3) << "x towards -z";
}

TEST(Meshopt, TheBytesOfAFallbackAreNotRead) {
    GltfBuilder builder = packedField(true);
    json fallback = emptyFallback();
    fallback["uri"] = "nowhere.bin";
    EXPECT_EQ(load(withFallback(builder, fallback)).triangleCount(), meshoptField.indices.size() / 3);
    // A view that is not packed needs the bytes.
    builder.add("bufferViews", {{"buffer", 1}, {"byteLength", 4}});
    expectMentions(loadError(withFallback(builder, fallback)), {"nowhere.bin"});
}

TEST(Meshopt, ErrorsAreNamed) {
    const auto errorOf = [](const char* key, json value) {
        GltfBuilder builder = packedField(true);
        for (json& view : builder.document["bufferViews"])
            if (view.contains("extensions")) {
                view["extensions"]["EXT_meshopt_compression"][key] = std::move(value);
                break;
            }
        return loadError(withFallback(builder, emptyFallback()));
    };
    const std::string what = "meshopt compression of buffer view 1";
    for (const auto& [key, value] : std::vector<std::pair<const char*, json>>{{"buffer", 7},
                                                                              {"buffer", -1},
                                                                              {"buffer", 1},
                                                                              {"byteOffset", 99999999},
                                                                              {"byteOffset", -4},
                                                                              {"byteLength", 99999999},
                                                                              {"byteLength", 20},
                                                                              {"byteStride", 13},
                                                                              {"byteStride", 0},
                                                                              {"byteStride", 512},
                                                                              {"count", 577},
                                                                              {"count", -1},
                                                                              {"mode", "TRIANGLES"},
                                                                              {"mode", "OTHER"},
                                                                              {"mode", 3},
                                                                              {"filter", "OCTAHEDRAL"},
                                                                              {"filter", "COLOR"}}) {
        const std::string error = errorOf(key, value);
        expectMentions(error, {"test.glb", "; "});
        EXPECT_TRUE(error.find(what) != std::string::npos || error.find("buffer 7") != std::string::npos)
            << key << " " << value << ": " << error;
    }
    expectMentions(errorOf("byteLength", 20), {"damaged"});
}

// Damaged streams load or are refused, which the sanitizers check best.
TEST(Meshopt, DamagedStreamsNeverCrash) {
    GltfBuilder builder = packedField(true);
    std::mt19937 random(7);
    int refused = 0;
    for (int i = 0; i < 300; ++i) {
        GltfBuilder damaged = builder;
        for (int bytes = 0; bytes < 4; ++bytes)
            damaged.binary[random() % damaged.binary.size()] = static_cast<unsigned char>(random());
        const std::string error = loadError(withFallback(damaged, emptyFallback()));
        if (!error.empty()) {
            ++refused;
            expectMentions(error, {"test.glb"});
        }
    }
    EXPECT_GT(refused, 20);
    EXPECT_LT(refused, 300);
}

#else

TEST(Meshopt, IsRefusedByTheNameOfTheLibrary) {
    GltfBuilder builder;
    builder.triangle();
    builder.document["bufferViews"][0]["buffer"] = 1;
    builder.document["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = json::object();
    builder.document["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["buffer"] = 0;
    builder.document["buffers"] = {
        {{"byteLength", 36}, {"uri", "data:application/octet-stream;base64," + base64(builder.binary)}},
        {{"byteLength", 36}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
    expectMentions(loadError(bytesOf(builder.document.dump())),
                   {"test.glb", "buffer view 0", "meshoptimizer", "VCT_MESHOPT"});
    // The bytes beside it are read without the library.
    builder.document["buffers"][1]["uri"] = builder.document["buffers"][0]["uri"];
    EXPECT_EQ(load(bytesOf(builder.document.dump())).triangleCount(), 1U);
}

#endif

}  // namespace
}  // namespace vct::test
