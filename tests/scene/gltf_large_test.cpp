// Large files: time grows linearly, memory is known before it is allocated, and messages stay short.
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <ctime>
#include <string>

#include "scene/gltf_file.h"
#include "support/errors.h"
#include "support/gltf_builder.h"

namespace vct::test {
namespace {

// A triangle with `count` nodes.
Bytes manyNodes(int count) {
    GltfBuilder builder;
    builder.triangle();
    std::string nodes = R"("nodes":[{"mesh":0})", roots = R"("nodes":[0)";
    for (int i = 1; i < count; ++i) {
        nodes += R"(,{"mesh":0,"translation":[)" + std::to_string(i % 1000) + "," + std::to_string(i / 1000) +
                 ",0]}";
        roots += "," + std::to_string(i);
    }
    builder.document.erase("nodes");
    builder.document.erase("scenes");
    const Bytes text = builder.gltfWithDataUri();
    const std::string rest(text.begin() + 1, text.end());
    return bytesOf("{" + nodes + R"(],"scenes":[{)" + roots + "]}]," + rest);
}

// Processor time, as other programs may run beside the test.
double secondsToLoad(const Bytes& file, std::size_t instances) {
    const std::clock_t start = std::clock();
    EXPECT_EQ(load(file).instances.size(), instances);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(LargeFiles, TimeGrowsWithTheNodesAndNotWithTheirSquare) {
    const double few = secondsToLoad(manyNodes(25000), 25000);
    const double many = secondsToLoad(manyNodes(200000), 200000);
    EXPECT_LT(many, 20.0 * few) << few << " s for 25000 nodes, " << many << " s for 200000";
}

// Triangles in a row along X. Each is a primitive with indices of its own, and all share one list of
// vertices, the first element of which lies elsewhere by a sparse value.
Bytes manyPrimitivesOfSharedVertices(int count) {
    GltfBuilder builder;
    std::vector<float> positions, colors;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < count; ++i) {
        const auto x = static_cast<float>(i);
        positions.insert(positions.end(), {x, 0, 0, x + 0.5F, 0, 0, x, 1, 0});
        for (int corner = 0; corner < 3; ++corner) {
            colors.insert(colors.end(), {static_cast<float>(i % 7) / 8.0F, 0, 1});
            indices.push_back(static_cast<std::uint32_t>(3 * i + corner));
        }
    }
    const int position = builder.floats(positions), color = builder.floats(colors);
    const std::vector<std::uint32_t> moved{3};
    const std::vector<float> place{1, -5, 0};
    builder.document["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", builder.view(moved.data(), 4)}, {"componentType", uint32}}},
        {"values", {{"bufferView", builder.view(place.data(), 12)}}}};
    const int view = builder.view(indices.data(), 4 * indices.size());
    json primitives = json::array();
    for (int i = 0; i < count; ++i) {
        const int own = builder.accessorOf(view, 3, uint32, "SCALAR");
        builder.document["accessors"][static_cast<std::size_t>(own)]["byteOffset"] = 12 * i;
        primitives.push_back(
            {{"attributes", {{"POSITION", position}, {"COLOR_0", color}}}, {"indices", own}});
    }
    builder.node({{"mesh", builder.add("meshes", {{"primitives", primitives}})}});
    return builder.glb();
}

TEST(LargeFiles, PrimitivesThatShareVerticesHaveTheirOwnOnly) {
    const Scene scene = load(manyPrimitivesOfSharedVertices(9));
    ASSERT_EQ(scene.meshes.size(), 9U);
    for (std::size_t i = 0; i < 9; ++i) {
        const Mesh& mesh = scene.meshes[i];
        ASSERT_EQ(mesh.vertices.size(), 3U);
        const auto at = [&](std::size_t corner) {
            return mesh.centre + glm::dvec3(mesh.vertices[mesh.indices[corner]].position);
        };
        const auto x = static_cast<double>(i);
        EXPECT_EQ(at(0), i == 1 ? glm::dvec3(1, -5, 0) : glm::dvec3(x, 0, 0));
        EXPECT_EQ(at(1), glm::dvec3(x + 0.5, 0, 0));
        EXPECT_EQ(at(2), glm::dvec3(x, 1, 0));
        EXPECT_EQ(mesh.extras.at(2).color, glm::vec4(static_cast<float>(i % 7) / 8.0F, 0, 1, 1));
    }
    const double few = secondsToLoad(manyPrimitivesOfSharedVertices(1250), 1250);
    const double many = secondsToLoad(manyPrimitivesOfSharedVertices(10000), 10000);
    EXPECT_LT(many, 20.0 * few) << few << " s for 1250 primitives, " << many << " s for 10000";
}

void appendBigEndian(Bytes& bytes, std::size_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<unsigned char>(value >> shift & 0xFF));
}

void appendChunk(Bytes& png, const char* type, const Bytes& data) {
    appendBigEndian(png, data.size());
    const std::size_t begin = png.size();
    png.insert(png.end(), type, type + 4);
    png.insert(png.end(), data.begin(), data.end());
    appendBigEndian(png, crc32_z(0, png.data() + begin, png.size() - begin));
}

// A black PNG of 8-bit RGB whose header says side x side pixels, with `inflated` bytes of deflated zeros.
Bytes zeroPng(std::size_t side, std::size_t inflated) {
    Bytes data;
    z_stream stream{};
    deflateInit(&stream, 9);
    const Bytes zeros(std::size_t{1} << 20);
    Bytes window(std::size_t{1} << 16);
    for (std::size_t left = inflated; left > 0;) {
        stream.next_in = const_cast<unsigned char*>(zeros.data());
        stream.avail_in = static_cast<unsigned>(std::min(left, zeros.size()));
        left -= stream.avail_in;
        do {
            stream.next_out = window.data();
            stream.avail_out = static_cast<unsigned>(window.size());
            deflate(&stream, left > 0 ? Z_NO_FLUSH : Z_FINISH);
            data.insert(data.end(), window.data(), window.data() + (window.size() - stream.avail_out));
        } while (stream.avail_out == 0);
    }
    deflateEnd(&stream);
    Bytes header;
    appendBigEndian(header, side);
    appendBigEndian(header, side);
    header.insert(header.end(), {8, 2, 0, 0, 0});
    Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    appendChunk(png, "IHDR", header);
    appendChunk(png, "IDAT", data);
    appendChunk(png, "IEND", {});
    return png;
}

TEST(Memory, ARequestThatDoesNotFitIsRefusedByName) {
    GltfFile file;
    file.path = "test.glb";
    file.limitBytes = 1000000000;
    file.reserve(600000000, "buffer 0, the file a.bin,");
    const std::string error =
        errorOf([&] { file.reserveTexture(500000000, "image 2 (wall.png), 16384 x 8192 pixels,"); });
    expectMentions(error, {"test.glb", "image 2 (wall.png), 16384 x 8192 pixels, asks for 500 MB",
                           "of the 1000 MB", "400 MB are left", "free memory"});
    EXPECT_EQ(file.usedBytes, 600000000U);
}

TEST(Memory, DeflatedDataThatTheHeaderDoesNotAskForIsNotInflated) {
    // A correct picture loads.
    EXPECT_EQ(load(completeFile(zeroPng(64, 64 * (64 * 3 + 1)))).textures.at(0).width, 64);
    const std::string error = loadError(completeFile(zeroPng(4, std::size_t{256} << 20)));
    expectMentions(error, {"test.glb", "image 0", "more data than its 4 x 4 pixels"});
}

}  // namespace
}  // namespace vct::test
