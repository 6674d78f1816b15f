// Picture files round-trip, and errors leave no file.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "image/files.h"
#include "scene/gltf.h"
#include "support/errors.h"
#include "support/temporary_folder.h"

namespace vct {
namespace {

using test::errorOf;
using test::expectMentions;
using Names = std::vector<std::string>;

// The error of readImage() without the disk, as thousands of files would take long.
std::string messageOfDecoding(const std::string& content) {
    const Bytes bytes(content.begin(), content.end());
    return errorOf([&] {
        imageFormat("cut", bytes) == ImageFormat::png ? decodePng("cut", bytes) : decodeExr("cut", bytes);
    });
}

Image gradient(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int step = (x + 7 * y) % 256;
            image.at(x, y) = {srgbDecode(float(step) / 255.0F), srgbDecode(float(255 - step) / 255.0F),
                              srgbDecode(float(x % 256) / 255.0F)};
        }
    }
    return image;
}

// An EXR with any channels. Each has one value, which follows from its name and is exact in half precision.
void writeExrPlanes(const std::string& path,
                    const std::vector<std::pair<std::string, Imf::PixelType>>& channels, int size) {
    Imf::Header header(size, size);
    Imf::FrameBuffer planes;
    std::vector<std::vector<std::pair<float, half>>> rows;
    for (const auto& [name, type] : channels) {
        const float value = float(name.back()) + 0.5F;
        auto& row = rows.emplace_back(size, std::pair<float, half>(value, value));
        header.channels().insert(name, Imf::Channel(type));
        void* const first = type == Imf::HALF ? static_cast<void*>(&row[0].second) : &row[0].first;
        // The stride between lines is 0, so every line is this row.
        planes.insert(name, Imf::Slice(type, static_cast<char*>(first), sizeof row[0], 0));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(planes);
    file.writePixels(size);
}

TEST(Srgb, RoundTripsEveryEightBitStep) {
    for (int i = 0; i < 256; ++i) {
        const float step = float(i) / 255.0F;
        EXPECT_EQ(std::lround(srgbEncode(srgbDecode(step)) * 255.0F), i);
        EXPECT_NEAR(srgbEncode(srgbDecode(step)), step, 2e-6F);
    }
}

TEST(Png, RoundTripsWithRowZeroAtTheTop) {
    const TemporaryFolder folder;
    const Image written = gradient(37, 19);
    writePng(folder.file("a.png"), written);
    const Image read = readImage(folder.file("a.png"));
    ASSERT_EQ(read.width, 37);
    ASSERT_EQ(read.height, 19);
    for (std::size_t i = 0; i < written.pixels.size(); ++i)
        EXPECT_EQ(read.pixels[i], written.pixels[i]) << i;
    EXPECT_EQ(folder.list(), Names{"a.png"});
}

TEST(Png, WritesNanAsBlackAndClampsTheRest) {
    const TemporaryFolder folder;
    Image image(2, 1, {std::nanf(""), 7.0F, -3.0F});
    image.at(1, 0) = glm::vec3(srgbDecode(0.4F));
    writePng(folder.file("a.png"), image);
    const Image read = readImage(folder.file("a.png"));
    EXPECT_EQ(read.at(0, 0), glm::vec3(0.0F, 1.0F, 0.0F));
    EXPECT_EQ(read.at(1, 0), glm::vec3(srgbDecode(102.0F / 255.0F)));
}

TEST(Exr, RoundTripsUnclampedValuesBitForBit) {
    const TemporaryFolder folder;
    for (const int side : {1, 40}) {  // OpenEXR packs small and large pictures differently
        Image written(side, side, {1e-6F, 1000.0F, -2.5F});
        written.at(side - 1, side - 1) = {1e30F, 0.1F, -0.0F};
        written.at(0, side - 1) = {std::nanf(""), std::numeric_limits<float>::infinity(), 3.0F};
        writeExr(folder.file("a.exr"), written);
        const Image read = readImage(folder.file("a.exr"));
        ASSERT_EQ(read.width, side);
        ASSERT_EQ(read.height, side);
        EXPECT_EQ(
            std::memcmp(read.pixels.data(), written.pixels.data(), written.pixels.size() * sizeof(glm::vec3)),
            0);
    }
    EXPECT_EQ(folder.list(), Names{"a.exr"});
}

TEST(Exr, ReadsHalfAndAnyOrderAndIgnoresAlpha) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.exr");
    const glm::vec3 expected('R' + 0.5F, 'G' + 0.5F, 'B' + 0.5F);
    for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT}) {
        writeExrPlanes(path, {{"R", type}, {"A", type}, {"G", type}, {"B", Imf::FLOAT}}, 20);
        const Image read = readImage(path);
        ASSERT_EQ(read.pixels.size(), 400U);
        for (const glm::vec3& pixel : read.pixels)
            ASSERT_EQ(pixel, expected);
    }
}

TEST(ReadImage, RefusesEveryTruncation) {
    const TemporaryFolder folder;
    writePng(folder.file("a.png"), gradient(20, 40));
    writeExr(folder.file("a.exr"), gradient(20, 40));
    writeExrPlanes(folder.file("b.exr"), {{"Y", Imf::FLOAT}}, 5);
    for (const char* name : {"a.png", "a.exr", "b.exr"}) {
        const std::string whole = readBytes(folder.file(name));
        ASSERT_GT(whole.size(), 100U);
        for (std::size_t size = 0; size < whole.size(); size += size < 600 ? 1 : 97) {
            const std::string message = messageOfDecoding(whole.substr(0, size));
            ASSERT_NE(message.find("cut'"), std::string::npos)
                << name << " cut to " << size << ": " << message;
            ASSERT_EQ(message.find("(string)"), std::string::npos) << message;
        }
    }
}

TEST(ReadImage, SurvivesChangedBytes) {
    const TemporaryFolder folder;
    writePng(folder.file("a.png"), gradient(20, 20));
    writeExr(folder.file("a.exr"), gradient(20, 20));
    for (const char* name : {"a.png", "a.exr"}) {
        const std::string whole = readBytes(folder.file(name));
        int refused = 0;
        for (std::size_t at = 0; at < whole.size(); ++at) {
            for (const char value : {'\x00', '\x7F', '\xFF'}) {
                std::string changed = whole;
                changed[at] = value;
                if (!messageOfDecoding(changed).empty()) ++ ++refused;
            }
        }
        EXPECT_GT(refused, 0) << name;
    }
}

TEST(ReadImage, NamesTheFileAndTheCause) {
    const TemporaryFolder folder;
    const auto message = [&](const std::string& name) {
        return errorOf([&] { readImage(folder.file(name)); });
    };
    expectMentions(message("none.png"), {"none.png: there is no such file"});
    writeBytes(folder.file("text.png"), "not a picture at all");
    expectMentions(message("text.png"), {"neither a PNG nor an EXR"});
    writeBytes(folder.file("empty.exr"), "");
    expectMentions(message("empty.exr"), {"empty"});
    expectMentions(message(""), {"it is not a file"});
}

TEST(ReadImage, RefusesEnormousPictures) {
    const TemporaryFolder folder;
    writePng(folder.file("a.png"), Image(8, 8));
    std::string png = readBytes(folder.file("a.png"));
    png.replace(16, 4, std::string("\x00\x00\x40\x01", 4));  // the width, big-endian: 16385
    png.replace(29, 4, std::string("\x61\x30\x1B\xF9", 4));  // and the checksum of that header
    writeBytes(folder.file("a.png"), png);
    expectMentions(errorOf([&] { readImage(folder.file("a.png")); }), {"16385 x 8"});

    writeExr(folder.file("a.exr"), Image(8, 8));
    std::string exr = readBytes(folder.file("a.exr"));
    const std::size_t window = exr.find("dataWindow");
    ASSERT_NE(window, std::string::npos);
    exr.replace(window + 21 + 8, 4, std::string("\x00\x40\x00\x00", 4));  // maxX, little-endian: 16384
    writeBytes(folder.file("a.exr"), exr);
    expectMentions(errorOf([&] { readImage(folder.file("a.exr")); }), {"maximum width of 16384"});
}

}  // namespace
}  // namespace vct
