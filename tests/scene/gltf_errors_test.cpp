#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>

#include "core/error.h"
#include "scene/gltf_file.h"
#include "support/errors.h"
#include "support/gltf_builder.h"
#include "support/temporary_folder.h"

namespace vct::test {
namespace {

// The message is one line that names the file and a remedy and contains `part`.
void expectError(const std::string& message, const std::string& part) {
    expectMentions(message, {"test.glb", part, "; "});
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

// A value that replaces the one at a place of the document (RFC 6901), or "" to remove it.
struct Damage {
    const char* place;
    const char* value;
    const char* part;  // of the message
};

const Damage damages[] = {
    {"/nodes/0/mesh", "7", "mesh 7"},
    {"/meshes/0/primitives/0/material", "7", "material 7"},
    {"/meshes/0/primitives/0/attributes/POSITION", "70", "accessor 70"},
    {"/meshes/0/primitives/0/indices", "70", "accessor"},
    {"/meshes/0", R"({"name": "wall", "primitives": [{"attributes": {"POSITION": 0}, "mode": 99}]})",
     "mesh 0 (wall) has the unknown mode 99"},
    {"/meshes/0/primitives/0/attributes", "", "attributes"},
    {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", "7", "texture 7"},
    {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", "", "index"},
    {"/materials/0/alphaMode", R"("GLOW")", "alpha mode"},
    {"/textures/0/source", "7", "image 7"},
    {"/textures/0/source", "", "texture 0"},
    {"/textures/0/sampler", "7", "sampler 7"},
    {"/samplers/0/wrapS", "1", "wrap"},
    {"/images/0/bufferView", "99", "buffer view 99"},
    {"/images/0/bufferView", "", "image 0"},
    {"/images/0/bufferView", "0", "neither PNG nor JPEG"},
    {"/bufferViews/4/byteLength", "40", "cannot be decoded"},
    {"/images/0", R"({"uri": "no%20such.png"})", "no such.png"},
    {"/nodes/1/camera", "7", "camera 7"},
    {"/cameras/0/perspective/yfov", "3.2", "camera 0 has a field of view"},
    {"/nodes/2/extensions/KHR_lights_punctual/light", "7", "light 7"},
    {"/extensions/KHR_lights_punctual/lights/0/intensity", "-1", "light 0 has a negative intensity"},
    {"/extensions/KHR_lights_punctual/lights/0",
     R"({"type": "directional", "name": "sun", "color": [1, -0.5, 1]})",
     "light 0 (sun) has a negative colour"},
    {"/skins", "[{}]", "skins[0]: a property is missing or has a wrong type"},
    {"/cameras/0", R"({"type": "perspective"})", "cameras[0]: "},
    {"/scene", "7", "scene 7"},
    {"/scenes/0/nodes", "[]", "no triangles"},
    {"/nodes/0/children", "[7]", "node 7"},
    {"/nodes/0/children", "[0]", "node 0 is in the scene twice"},
    {"/nodes", R"([{"mesh": 0}, {"children": [2]}, {"children": [1]}])", "its own ancestor"},
    {"/nodes", R"([{"mesh": 0, "children": [2]}, {"children": [2]}, {}])", "two parents"},
    {"/nodes/0/matrix", "[1, 0, 0]", "wrong number"},
    {"/nodes/0/matrix", "[1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]", "last row"},
    {"/nodes/0/rotation", "[0, 0, 0, 0]", "quaternion"},
    {"/nodes/0/translation", "[1e300, 0, 0]", "not a usable number"},
    {"/bufferViews/0/byteLength", "18446744073709551615", "buffer view 0"},
    {"/bufferViews/1/byteOffset", "18446744073709551612", "buffer view 1"},
    {"/bufferViews/0/buffer", "4", "buffer 4"},
    {"/accessors/0/bufferView", "99", "buffer view 99"},
    {"/accessors/0/byteOffset", "18446744073709551615", "accessor 0"},
    {"/accessors/0/count", "18446744073709551615", "accessor 0"},
    {"/accessors/0", R"({"componentType": 5126, "count": 1099511627776, "type": "VEC3"})", "2^32 elements"},
    {"/bufferViews/0/byteStride", "16", "accessor 0"},
    {"/bufferViews/0/byteStride", "4", "stride"},
    {"/accessors/0/componentType", "5125", "component type"},
    {"/accessors/0/componentType", "1", "omponentType"},
    {"/accessors/0/type", R"("VEC2")", "VEC3"},
    {"/accessors/0/count", "2", "points at vertex 2 of 2"},
    {"/accessors/1/count", "2", "NORMAL"},
    {"/accessors/2/componentType", "5123", "component type"},
    {"/accessors/3/componentType", "5126", "unsigned"},
    {"/accessors/3/count", "2", "no triangles"},
    {"/meshes/0/primitives/0/mode", "1", "no triangles (points and lines are left out)"},
    {"/accessors/0/sparse/indices/byteOffset", "6", "writes element 3 of 3"},
    {"/accessors/0/sparse/indices/byteOffset", "-2", "negative"},
    {"/accessors/0/sparse/indices/componentType", "5126", "sparse"},
    {"/accessors/0/sparse/count", "99", "sparse"},
    {"/animations/0/channels/0/sampler", "", "animation 0 (spin), channel 0 has no sampler"},
    {"/animations/0/channels/0/sampler", "3", "channel 0 refers to sampler 3 of 1"},
    {"/animations/0/channels/0/target", "", "channel 0 has no target"},
    {"/animations/0/channels/0/target/node", "9", "node 9 of 3"},
    {"/animations/0/channels/1", R"({"sampler": 0, "target": {"node": 0, "path": "rotation"}})",
     "channel 1 moves the rotation of node 0, which another channel moves already"},
    {"/animations/0/samplers/0/input", "", "channel 0 has a sampler without input"},
    {"/animations/0/samplers/0/input", "0", "is not a SCALAR"},
    {"/animations/0/samplers/0/output", "0", "is not a VEC4"},
    {"/animations/0/samplers/0/output", "99", "accessor 99 of 6"},
    {"/animations/0/samplers/0/interpolation", R"("BEZIER")", "unknown interpolation \"BEZIER\""},
    {"/animations/0/samplers/0/interpolation", R"("CUBICSPLINE")", "where 6 are needed"},
    {"/accessors/5/componentType", "5123", "component type 5123"},
    {"/nodes/0/matrix", "[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]", "moves a node that has a matrix"},
    {"/animations", "5", "its animations are not a list of objects"},
    {"/animations/0/channels", "5", "its channels are not a list of objects"},
    {"/animations/0/samplers", "[7]", "its samplers are not a list of objects"},
    {"/buffers", R"([{"byteLength": 4, "uri": "gone.bin"}])", "gone.bin"},
    {"/buffers", R"([{"byteLength": 1125899906842624}])", "buffer 0 is cut short"},
    {"/buffers", "[{}]", "byteLength"},
    {"/buffers", R"([{"byteLength": 9}, {"byteLength": 9}])", "buffer"},
    {"/buffers", R"([{"byteLength": 4, "uri": "data:;base64,!!!!"}])", "base64"},
    {"/asset/version", R"("1.0")", "glTF 1.0"},
    {"/asset/minVersion", R"("2.1")", "glTF 2.1"},
    {"/asset", "", "asset.version"},
};

TEST(GltfErrors, TheUndamagedFileLoads) {
    const Scene scene = load(completeFile(encodePng(8)));
    EXPECT_EQ(scene.triangleCount(), 1U);
    EXPECT_EQ(scene.textures.size(), 1U);
    EXPECT_EQ(scene.cameras.size(), 1U);
    EXPECT_EQ(scene.lights.size(), 1U);
}

TEST(GltfErrors, EachDamageIsNamedInOneSentence) {
    for (const Damage& damage : damages) {
        SCOPED_TRACE(std::string(damage.place) + " " + damage.value);
        GltfBuilder builder = completeFile(encodePng(8));
        const json::json_pointer place(damage.place);
        if (*damage.value == '\0')
            builder.document[place.parent_pointer()].erase(place.back());
        else
            builder.document[place] = json::parse(damage.value);
        // The animation must be asked for, else its errors are warnings.
        expectError(loadError(builder, {.animation = "0"}), damage.part);
    }
}

TEST(GltfErrors, UnusablePositionsAreNamed) {
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

TEST(GltfErrors, ImagesWithAWrongSizeAreNamed) {
    for (const int side : {16384, 16385, 1 << 30}) {
        Bytes png = encodePng(8);
        for (std::size_t byte = 0; byte < 4; ++byte) {  // width and height, big-endian, at 16 and 20
            png[16 + byte] = png[20 + byte] = static_cast<unsigned char>((side >> (24 - 8 * byte)) & 0xFF);
        }
        GltfBuilder builder = completeFile(encodePng(8));
        const int view = builder.view(png.data(), png.size());
        builder.document["images"][0]["bufferView"] = view;
        expectError(loadError(builder), "image 0");
    }
}

// stb_image puts the name into its reason, and a zero in the name ends the reason.
TEST(GltfErrors, AnImageWithAChunkWithoutANameHasAReason) {
    for (const std::size_t letter : {0U, 2U}) {
        Bytes image = encodePng(8);
        const auto data = bytesOf("IDAT");
        const auto chunk = std::search(image.begin(), image.end(), data.begin(), data.end());
        ASSERT_NE(chunk, image.end());
        chunk[static_cast<std::ptrdiff_t>(letter)] = 0;
        expectError(loadError(completeFile(image)), "image 0 cannot be decoded: its data are damaged");
    }
}

TEST(GltfErrors, DeepNodesAndDeepJsonAreRefused) {
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

TEST(GltfErrors, FilesThatAreNotGltfAreRefused) {
    const Bytes nothing;
    expectError(loadError(nothing), "empty");
    for (const char* text : {"glTF", "[]", "{}", "{\"asset\":{\"version\":\"2.0\"}}"})
        expectError(loadError(bytesOf(text)), "");
    for (const char* text : {"g", "null", " \n", "\x89PNG",
                             "\xEF\xBB\xBF"
                             "7"})
        expectError(loadError(bytesOf(text)), "it is neither JSON (.gltf) nor binary glTF (.glb)");
    expectError(loadError(bytesOf("\xEF\xBB\xBF {")), "its JSON is damaged (parse error at line 1");
    Bytes newer = completeFile(encodePng(8)).glb();
    newer[4] = 3;
    expectError(loadError(newer), "version 3");
}

TEST(GltfErrors, FilesOfOtherFormatsAreNamedWithTheWayToGltf) {
    const std::pair<const char*, const char*> files[] = {
        {"chair.obj", "v 0 0 0"}, {"chair.FBX", "; FBX 7.4.0"},    {"chair", "Kaydara FBX Binary  "},
        {"chair.usdz", "PK"},     {"chair.blend", "BLENDER-v306"}, {"chair.step", "ISO-10303-21;"},
        {"chair.skp", "\xff\xfe"}};
    for (const auto& [name, content] : files) {
        const std::string error = errorOf([&, path = name, text = content] {
            loadGltf(path, [&](const std::string&) { return bytesOf(text); });
        });
        expectMentions(error, {name, "it is a", "only glTF is read", "xport"});
    }
    // The content decides: some programs give glTF another ending.
    const Bytes good = completeFile(encodePng(8)).glb();
    EXPECT_EQ(loadGltf("chair.obj", [&](const std::string&) { return good; }).instances.size(), 1U);
}

// A whole number may be written as 60.0, and an accessor without a view is zeros (glTF 2.0).
TEST(GltfFiles, MayHaveNumbersAndAccessorsThatTheSpecificationAllows) {
    GltfBuilder plain = completeFile(encodePng(8));
    // Every number of the document as a fraction.
    const std::function<void(json&)> asFraction = [&](json& value) {
        if (value.is_number_integer()) value = value.get<double>();
        if (value.is_structured())
            for (json& element : value)
                asFraction(element);
    };
    GltfBuilder fractions = plain;
    fractions.document["buffers"] = {{{"byteLength", plain.binary.size()}}};
    asFraction(fractions.document);
    const std::string written = fractions.document.dump();
    EXPECT_NE(written.find("\"mesh\":0.0"), std::string::npos) << written;
    const Scene scene = load(fractions);
    EXPECT_EQ(triangleSoup(scene.meshes.at(0)), triangleSoup(load(plain).meshes.at(0)));
    EXPECT_EQ(scene.textures.at(0).rgba, load(plain).textures.at(0).rgba);
    EXPECT_EQ(scene.cameras.size(), 1U);

    GltfBuilder zeros = plain;
    zeros.document["accessors"][2].erase("bufferView");  // texture coordinates
    EXPECT_EQ(load(zeros).meshes.at(0).vertices.at(1).uv, glm::vec2(0.0F));
}

TEST(GltfFiles, IndicesWithoutABufferViewAreZerosButForTheirSparseElements) {
    GltfBuilder b;
    const int positions = b.floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int indices = b.add("accessors", {{"count", 6}, {"componentType", 5125}, {"type", "SCALAR"}});
    b.node({{"mesh", b.mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}})}});
    b.triangle();
    EXPECT_EQ(load(b).meshes.at(0).indices.size(), 6U);

    const std::uint32_t where[] = {4, 5}, values[] = {1, 2};
    b.document["accessors"][1]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", b.view(where, sizeof where)}, {"componentType", 5125}}},
        {"values", {{"bufferView", b.view(values, sizeof values)}}}};
    const Mesh mesh = load(b).meshes.at(0);
    EXPECT_EQ(mesh.vertices.at(mesh.indices.at(4)).position + glm::vec3(mesh.centre), glm::vec3(1, 0, 0));

    b.document["accessors"][1]["bufferView"] = 99;
    expectError(loadError(b), "accessor");
}

TEST(GltfFiles, ChunksWithoutPaddingAreDrawnWithAWarning) {
    GltfBuilder builder = completeFile(encodePng(8));
    const Bytes whole = builder.glb();
    EXPECT_FALSE(hasWarning(load(whole), "multiple of 4"));
    for (std::size_t spaces : {1U, 2U, 3U})
        for (const bool isCounted : {true, false}) {
            // The length of the JSON chunk counts all of its spaces, or only those up to a multiple of 4.
            Bytes odd = whole;
            const std::size_t size = odd[12] | odd[13] << 8U;
            if (isCounted)
                odd.insert(odd.begin() + static_cast<std::ptrdiff_t>(20 + size), spaces, ' ');
            else
                odd.insert(odd.begin() + static_cast<std::ptrdiff_t>(20 + size), 4, ' ');
            odd[12] = static_cast<unsigned char>((size + spaces) & 255U);
            odd[13] = static_cast<unsigned char>((size + spaces) >> 8U);
            odd[8] = static_cast<unsigned char>(odd.size() & 255U);
            odd[9] = static_cast<unsigned char>((odd.size() >> 8U) & 255U);
            const Scene scene = load(odd);
            EXPECT_TRUE(hasWarning(scene, "multiple of 4"));
            EXPECT_EQ(triangleSoup(scene.meshes.at(0)), triangleSoup(load(whole).meshes.at(0)));
            EXPECT_EQ(scene.textures.at(0).rgba, load(whole).textures.at(0).rgba);
        }
}

// A small file may name the same accessor or image any number of times.
TEST(GltfErrors, MemoryIsCountedAndLimited) {
    GltfFile file;
    file.path = "test.glb";
    file.reserveGeometry(1U << 30, 1);
    EXPECT_THROW(file.reserveGeometry((1U << 30) + 1, 1), Error);
    EXPECT_THROW(file.reserveGeometry(~std::size_t{0} / 2, 40), Error);
    file.reserveGeometry(1U << 30, 1);
    file.reserveTexture(std::size_t{3} << 30, "image 0");
    EXPECT_THROW(file.reserveTexture(std::size_t{2} << 30, "image 1"), Error);
    EXPECT_THROW(file.reserveTexture(~std::size_t{0}, "image 1"), Error);
}

TEST(GltfFiles, TextWithDataUriAndBinaryAreTheSame) {
    const Scene binary = load(completeFile(encodePng(8)).glb());
    const Scene text = load(completeFile(encodePng(8)).gltfWithDataUri());
    EXPECT_EQ(triangleSoup(text.meshes.at(0)), triangleSoup(binary.meshes.at(0)));
    EXPECT_EQ(text.textures.at(0).rgba, binary.textures.at(0).rgba);
}

TEST(GltfFiles, BuffersAndImagesAreFoundBesideTheFile) {
    const TemporaryFolder folder;
    const auto write = [&](const std::string& name, const Bytes& bytes) {
        writeBytes(folder.file(name), bytes);
    };
    std::filesystem::create_directories(folder.file("parts"));
    GltfBuilder builder = completeFile(encodePng(8));
    builder.document["images"][0] = {{"uri", "parts/../parts/a%20picture.png"}};
    write("scene.gltf", builder.gltf("parts/scene.bin"));
    Bytes longer = builder.binary;  // glTF allows a file that is longer than the buffer
    longer.push_back(0);
    write("parts/scene.bin", longer);
    write("parts/a picture.png", encodePng(8));
    const Scene scene = loadGltf(folder.file("scene.gltf"));
    EXPECT_EQ(scene.path, folder.file("scene.gltf"));
    EXPECT_EQ(triangleSoup(scene.meshes.at(0)), triangleSoup(load(completeFile(encodePng(8))).meshes.at(0)));
    EXPECT_EQ(scene.textures.at(0).width, 8);
}

TEST(GltfFiles, ThatCannotBeReadAreErrors) {
    const TemporaryFolder folder;
    for (const std::string& path : {folder.file("absent.glb"), folder.path(), std::string("/dev/zero")})
        EXPECT_THROW(loadGltf(path), Error) << path;
}

}  // namespace
}  // namespace vct::test
