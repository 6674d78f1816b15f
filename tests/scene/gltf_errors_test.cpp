#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>

#include "core/error.h"
#include "scene/gltf_file.h"
#include "support/gltf_builder.h"

namespace vct::test {
namespace {

// One sentence that names the file, on one line, and contains `part`.
void expectError(const std::string& message, const std::string& part) {
    EXPECT_NE(message, "") << "loaded, expected: " << part;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find("test.glb"), std::string::npos) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_NE(message.find("; "), std::string::npos) << "no remedy: " << message;
}

// A valid file with an indexed, textured triangle, a camera and a light.
GltfBuilder complete() {
    GltfBuilder b;
    const int positions = b.floats({0, 0, 0, 1, 0, 0, 0, 1, 0});  // accessor, view 0
    const int normals = b.floats({0, 0, 1, 0, 0, 1, 0, 0, 1});    // 1
    const int uv = b.floats({0, 0, 1, 0, 0, 1}, "VEC2");          // 2
    const int indices = b.accessor(std::vector<std::uint16_t>{0, 1, 2, 3}, uint16, "SCALAR");  // 3
    b.document["accessors"][3]["count"] = 3;
    b.texture(encodePng(8));
    b.document["textures"][0]["sampler"] = b.add("samplers", {{"wrapS", 10497}});
    b.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    b.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}});
    b.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "directional"}}};
    b.node(
        {{"mesh", b.mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uv}}},
                          {"indices", indices},
                          {"material", 0}})}});
    b.node({{"camera", 0}});
    b.node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return b;
}

struct Damage {
    const char* name;
    std::function<void(json&)> apply;
    const char* part;  // of the message
};

json& primitive(json& d) {
    return d["meshes"][0]["primitives"][0];
}

const Damage damages[] = {
    {"MeshOutOfRange", [](json& d) { d["nodes"][0]["mesh"] = 7; }, "mesh 7"},
    {"NegativeMesh", [](json& d) { d["nodes"][0]["mesh"] = -2; }, "mesh -2"},
    {"MaterialOutOfRange", [](json& d) { primitive(d)["material"] = 7; }, "material 7"},
    {"AccessorOutOfRange", [](json& d) { primitive(d)["attributes"]["POSITION"] = 70; }, "accessor 70"},
    {"IndicesOutOfRange", [](json& d) { primitive(d)["indices"] = 70; }, "accessor"},
    {"TextureOutOfRange",
     [](json& d) { d["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 7; },
     "texture 7"},
    {"ImageOutOfRange", [](json& d) { d["textures"][0]["source"] = 7; }, "image 7"},
    {"TextureWithoutImage", [](json& d) { d["textures"][0].erase("source"); }, "texture 0"},
    {"SamplerOutOfRange", [](json& d) { d["textures"][0]["sampler"] = 7; }, "sampler 7"},
    {"UnknownWrap", [](json& d) { d["samplers"][0]["wrapS"] = 1; }, "wrap"},
    {"ImageViewOutOfRange", [](json& d) { d["images"][0]["bufferView"] = 99; }, "buffer view 99"},
    {"ImageViewAbsurd", [](json& d) { d["images"][0]["bufferView"] = 1ULL << 60; }, "buffer view"},
    {"ImageOfNothing", [](json& d) { d["images"][0].erase("bufferView"); }, "image 0"},
    {"ImageNotDecodable", [](json& d) { d["images"][0]["bufferView"] = 0; }, "neither PNG nor JPEG"},
    {"ImageCutShort", [](json& d) { d["bufferViews"][4]["byteLength"] = 40; }, "cannot be decoded"},
    {"ImageMissing",
     [](json& d) {
         d["images"][0] = {{"uri", "no%20such.png"}};
     },
     "no such.png"},
    {"CameraOutOfRange", [](json& d) { d["nodes"][1]["camera"] = 7; }, "camera 7"},
    {"CameraFov", [](json& d) { d["cameras"][0]["perspective"]["yfov"] = 3.2; },
     "camera 0 has a field of view"},
    {"LightOutOfRange", [](json& d) { d["nodes"][2]["extensions"]["KHR_lights_punctual"]["light"] = 7; },
     "light 7"},
    {"NegativeIntensity",
     [](json& d) { d["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"] = -1; },
     "light 0 has a negative intensity"},
    {"NegativeLightColour",
     [](json& d) {
         json& light = d["extensions"]["KHR_lights_punctual"]["lights"][0];
         light["name"] = "sun";
         light["color"] = {1, -0.5, 1};
     },
     "light 0 (sun) has a negative colour"},
    {"UnnamedMesh", [](json& d) { primitive(d)["mode"] = 99; }, "mesh 0 has the unknown mode 99"},
    {"NamedMesh",
     [](json& d) {
         d["meshes"][0]["name"] = "wall";
         primitive(d)["mode"] = 99;
     },
     "mesh 0 (wall) has the unknown mode 99"},
    {"SceneOutOfRange", [](json& d) { d["scene"] = 7; }, "scene 7"},
    {"RootOutOfRange", [](json& d) { d["scenes"][0]["nodes"] = {7}; }, "node 7"},
    {"ChildOutOfRange", [](json& d) { d["nodes"][0]["children"] = {7}; }, "node 7"},
    {"NodeIsItsOwnChild", [](json& d) { d["nodes"][0]["children"] = {0}; }, "cycle"},
    {"NodesInACycle",
     [](json& d) {
         d["nodes"][1]["children"] = {2};
         d["nodes"][2]["children"] = {1};
     },
     "cycle"},
    {"NodeIsAChildTwice",
     [](json& d) {
         d["nodes"][0]["children"] = {2};
         d["nodes"][1]["children"] = {2};
     },
     "child twice"},
    {"RootIsAlsoAChild", [](json& d) { d["nodes"][0]["children"] = {2}; }, "twice"},
    {"MatrixTooShort",
     [](json& d) {
         d["nodes"][0]["matrix"] = {1, 0, 0};
     },
     "wrong number"},
    {"MatrixIsProjective",
     [](json& d) { d["nodes"][0]["matrix"] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; }, "last row"},
    {"ZeroRotation",
     [](json& d) {
         d["nodes"][0]["rotation"] = {0, 0, 0, 0};
     },
     "quaternion"},
    {"HugeTranslation",
     [](json& d) {
         d["nodes"][0]["translation"] = {1e300, 0, 0};
     },
     "not a usable number"},
    {"ViewBeyondBuffer", [](json& d) { d["bufferViews"][0]["byteOffset"] = 1 << 30; }, "buffer view 0"},
    {"ViewLengthOverflows", [](json& d) { d["bufferViews"][0]["byteLength"] = ~0ULL; }, "buffer view 0"},
    {"ViewOffsetOverflows", [](json& d) { d["bufferViews"][1]["byteOffset"] = ~0ULL - 3; }, "buffer view 1"},
    {"ViewOfNoBuffer", [](json& d) { d["bufferViews"][0]["buffer"] = 4; }, "buffer 4"},
    {"AccessorOfNoView", [](json& d) { d["accessors"][0]["bufferView"] = 99; }, "buffer view 99"},
    {"AccessorOffset", [](json& d) { d["accessors"][0]["byteOffset"] = 4; }, "accessor 0"},
    {"AccessorOffsetOverflows", [](json& d) { d["accessors"][0]["byteOffset"] = ~0ULL; }, "accessor 0"},
    {"AccessorCountLies", [](json& d) { d["accessors"][0]["count"] = 4; }, "accessor 0"},
    {"AccessorCountOverflows", [](json& d) { d["accessors"][0]["count"] = ~0ULL; }, "accessor 0"},
    {"AccessorCountWithoutView",
     [](json& d) {
         d["accessors"][0].erase("bufferView");
         d["accessors"][0]["count"] = 1ULL << 40;
     },
     "MiB"},
    {"StrideReachesBeyond", [](json& d) { d["bufferViews"][0]["byteStride"] = 16; }, "accessor 0"},
    {"StrideBelowElement", [](json& d) { d["bufferViews"][0]["byteStride"] = 4; }, "stride"},
    {"PositionsAreIntegers", [](json& d) { d["accessors"][0]["componentType"] = uint32; }, "component type"},
    {"PositionsAreSigned", [](json& d) { d["accessors"][0]["componentType"] = int32; }, "component type"},
    {"PositionsAreVec2", [](json& d) { d["accessors"][0]["type"] = "VEC2"; }, "VEC3"},
    {"UvIsNotNormalized", [](json& d) { d["accessors"][2]["componentType"] = uint16; }, "component type"},
    {"IndicesAreFloat", [](json& d) { d["accessors"][3]["componentType"] = float32; }, "unsigned"},
    {"IndicesAreVectors", [](json& d) { d["accessors"][3]["type"] = "VEC2"; }, "unsigned"},
    {"ComponentTypeUnknown", [](json& d) { d["accessors"][0]["componentType"] = 1; }, "omponentType"},
    {"FewerNormalsThanPositions", [](json& d) { d["accessors"][1]["count"] = 2; }, "NORMAL"},
    {"FewerUvThanPositions", [](json& d) { d["accessors"][2]["count"] = 2; }, "TEXCOORD_0"},
    {"IndexBeyondVertices", [](json& d) { d["accessors"][0]["count"] = 2; }, "points at vertex 2 of 2"},
    {"ZeroTriangles", [](json& d) { d["accessors"][3]["count"] = 2; }, "no triangles"},
    {"NoNodes", [](json& d) { d["scenes"][0]["nodes"] = json::array(); }, "no triangles"},
    {"PrimitiveModeUnknown", [](json& d) { primitive(d)["mode"] = 9; }, "mode 9"},
    {"AlphaModeUnknown", [](json& d) { d["materials"][0]["alphaMode"] = "GLOW"; }, "alpha mode"},
    {"TextureWithoutIndex",
     [](json& d) { d["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"].erase("index"); }, "index"},
    {"PrimitiveWithoutAttributes", [](json& d) { primitive(d).erase("attributes"); }, "attributes"},
    {"SparseIndexBeyondCount",
     [](json& d) {
         d["accessors"][0]["sparse"] = {
             {"count", 1},
             {"indices", {{"bufferView", 3}, {"byteOffset", 6}, {"componentType", uint16}}},
             {"values", {{"bufferView", 1}}}};
     },
     "writes element 3 of 3"},
    {"SparseCountLies",
     [](json& d) {
         d["accessors"][0]["sparse"] = {{"count", 99},
                                        {"indices", {{"bufferView", 3}, {"componentType", uint16}}},
                                        {"values", {{"bufferView", 1}}}};
     },
     "sparse"},
    {"SparseOffsetIsNegative",
     [](json& d) {
         d["accessors"][0]["sparse"] = {
             {"count", 1},
             {"indices", {{"bufferView", 3}, {"byteOffset", -2}, {"componentType", uint16}}},
             {"values", {{"bufferView", 1}}}};
     },
     "negative"},
    {"SparseIndicesAreFloat",
     [](json& d) {
         d["accessors"][0]["sparse"] = {{"count", 1},
                                        {"indices", {{"bufferView", 3}, {"componentType", float32}}},
                                        {"values", {{"bufferView", 1}}}};
     },
     "sparse"},
    {"BufferMissing",
     [](json& d) {
         d["buffers"] = {{{"byteLength", 4}, {"uri", "gone.bin"}}};
     },
     "gone.bin"},
    {"BufferLengthLies",
     [](json& d) {
         d["buffers"] = {{{"byteLength", 1ULL << 50}}};
     },
     "buffer 0 is cut short"},
    {"BufferWithoutLength", [](json& d) { d["buffers"] = {json::object()}; }, "byteLength"},
    {"SecondBufferWithoutBytes",
     [](json& d) {
         d["buffers"] = {{{"byteLength", 9}}, {{"byteLength", 9}}};
     },
     "buffer"},
    {"DataUriNotBase64",
     [](json& d) {
         d["buffers"] = {{{"byteLength", 4}, {"uri", "data:;base64,!!!!"}}};
     },
     "base64"},
    {"BuffersAreNotObjects",
     [](json& d) {
         d["buffers"] = {1, 2};
     },
     "buffers"},
    {"OldVersion", [](json& d) { d["asset"]["version"] = "1.0"; }, "glTF 1.0"},
    {"NewerMinVersion", [](json& d) { d["asset"]["minVersion"] = "2.1"; }, "glTF 2.1"},
    {"NoAsset", [](json& d) { d.erase("asset"); }, "asset.version"},
    {"AssetIsANumber", [](json& d) { d["asset"] = 3; }, "asset.version"},
};

TEST(GltfErrors, TheFileThatIsDamagedBelowLoads) {
    const Scene scene = load(complete());
    EXPECT_EQ(scene.triangleCount(), 1U);
    EXPECT_EQ(scene.textures.size(), 1U);
    EXPECT_EQ(scene.cameras.size(), 1U);
    EXPECT_EQ(scene.lights.size(), 1U);
}

TEST(GltfErrors, EachDamageIsNamedInOneSentence) {
    for (const Damage& damage : damages) {
        SCOPED_TRACE(damage.name);
        GltfBuilder builder = complete();
        damage.apply(builder.document);
        expectError(loadError(builder), damage.part);
    }
}

TEST(GltfErrors, PositionsThatAreNotUsable) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {infinity, -infinity, std::nanf(""), 3e38F, 2e30F, 1e20F}) {
        GltfBuilder builder;
        builder.node(
            {{"mesh", builder.mesh(
                          {{"attributes", {{"POSITION", builder.floats({0, 0, 0, bad, 0, 0, 0, 1, 0})}}}})}});
        expectError(loadError(builder), "position");
    }
    GltfBuilder point;
    point.node(
        {{"mesh", point.mesh({{"attributes", {{"POSITION", point.floats(std::vector<float>(9, 1.0F))}}}})}});
    expectError(loadError(point), "one point");
}

TEST(GltfErrors, ImagesThatLieAboutTheirSize) {
    for (const int side : {16384, 16385, 1 << 30}) {
        Bytes png = encodePng(8);
        for (std::size_t byte = 0; byte < 4; ++byte) {  // width and height, big-endian, at 16 and 20
            png[16 + byte] = png[20 + byte] = static_cast<unsigned char>((side >> (24 - 8 * byte)) & 0xFF);
        }
        GltfBuilder builder = complete();
        const int view = builder.view(png.data(), png.size());
        builder.document["images"][0]["bufferView"] = view;
        expectError(loadError(builder), "image 0");
    }
}

TEST(GltfErrors, DeepNodesAndDeepJson) {
    GltfBuilder builder;
    builder.triangle();
    for (int i = 1; i < 5000; ++i)
        builder.add("nodes", {{"children", {i - 1}}});
    builder.document["scenes"][0]["nodes"] = {4999};
    expectError(loadError(builder), "levels deep");

    const std::string nested = R"({"asset":{"version":"2.0"},"extras":)" + std::string(1000000, '[');
    expectError(loadError(bytesOf(nested)), "levels deep");
    expectError(loadError(bytesOf(nested + std::string(1000000, ']') + "}")), "levels deep");
}

TEST(GltfErrors, FilesThatAreNotGltf) {
    const Bytes nothing;
    expectError(loadError(nothing), "empty");
    for (const char* text :
         {"g", "glTF", "{", "[]", "null", "{}", "\x89PNG", "{\"asset\":{\"version\":\"2.0\"}}"})
        expectError(loadError(bytesOf(text)), "");
    Bytes newer = complete().glb();
    newer[4] = 3;
    expectError(loadError(newer), "version 3");
}

// A small file may name the same accessor or image any number of times.
TEST(GltfErrors, WhatIsAllocatedIsCountedAndLimited) {
    GltfFile file;
    file.path = "test.glb";
    file.reserveGeometry(1U << 30, 1);
    EXPECT_THROW(file.reserveGeometry((1U << 30) + 1, 1), Error);
    EXPECT_THROW(file.reserveGeometry(~std::size_t{0} / 2, 40), Error);
    file.reserveGeometry(1U << 30, 1);
    file.reserveTexture(std::size_t{3} << 30);
    EXPECT_THROW(file.reserveTexture(std::size_t{2} << 30), Error);
    EXPECT_THROW(file.reserveTexture(~std::size_t{0}), Error);
}

TEST(GltfFiles, TextWithDataUriAndBinaryAreTheSame) {
    const Scene binary = load(complete().glb());
    const Scene text = load(complete().gltfWithDataUri());
    EXPECT_EQ(triangleSoup(text.meshes.at(0)), triangleSoup(binary.meshes.at(0)));
    EXPECT_EQ(text.textures.at(0).rgba, binary.textures.at(0).rgba);
}

class GltfFolder : public ::testing::Test {
  protected:
    std::filesystem::path folder;

    void SetUp() override {
        std::string pattern = (std::filesystem::temp_directory_path() / "vct-gltf-XXXXXX").string();
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        folder = pattern;
        std::filesystem::create_directories(folder / "parts");
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    void write(const std::string& name, const Bytes& bytes) {
        std::ofstream(folder / name, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
};

TEST_F(GltfFolder, BuffersAndImagesAreFoundBesideTheFile) {
    GltfBuilder builder = complete();
    builder.document["images"][0] = {{"uri", "parts/../parts/a%20picture.png"}};
    write("scene.gltf", builder.gltf("parts/scene.bin"));
    Bytes longer = builder.binary;  // glTF allows a file that is longer than the buffer
    longer.push_back(0);
    write("parts/scene.bin", longer);
    write("parts/a picture.png", encodePng(8));
    const Scene scene = loadGltf((folder / "scene.gltf").string());
    EXPECT_EQ(scene.path, (folder / "scene.gltf").string());
    EXPECT_EQ(triangleSoup(scene.meshes.at(0)), triangleSoup(load(complete()).meshes.at(0)));
    EXPECT_EQ(scene.textures.at(0).width, 8);
}

TEST_F(GltfFolder, ThatWhichIsNoReadableFileIsAnError) {
    for (const std::string& path :
         {(folder / "absent.glb").string(), folder.string(), std::string("/dev/zero")})
        EXPECT_THROW(loadGltf(path), Error) << path;
}

}  // namespace
}  // namespace vct::test
