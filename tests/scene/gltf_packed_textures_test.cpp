// WebP textures, encoded here by their library, and fallbacks.
#include <gtest/gtest.h>

#ifdef VCT_HAS_WEBP
#include <webp/encode.h>
#endif

#include <random>

#include "support/errors.h"
#include "support/packed_mesh.h"

namespace vct::test {
namespace {

// A field with a texture.
struct TexturedField {
    GltfBuilder builder = plainField(BumpyField(3));
    json texture = json::object();

    int image(const Bytes& bytes) {
        return builder.add("images",
                           {{"name", "wall"}, {"bufferView", builder.view(bytes.data(), bytes.size())}});
    }
    GltfBuilder file() const {
        GltfBuilder result = builder;
        result.add("textures", texture);
        result.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
        result.document["meshes"][0]["primitives"][0]["material"] = 0;
        return result;
    }
};

[[maybe_unused]] std::vector<std::uint8_t> picturePixels() {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 16; ++x)
            for (const int channel : {x * 15, y * 10, 100 + x - y, x == y ? 128 : 255})
                rgba.push_back(static_cast<std::uint8_t>(channel));
    return rgba;
}

// Mean difference between the texture and picturePixels(), in steps of 255.
[[maybe_unused]] double differenceFromThePicture(const Scene& scene) {
    EXPECT_TRUE(scene.warnings.empty());
    const Texture& texture = scene.textures.at(0);
    const std::vector<std::uint8_t> expected = picturePixels();
    EXPECT_EQ(texture.width, 16);
    EXPECT_EQ(texture.height, 24);
    if (texture.rgba.size() != expected.size()) return 255.0;
    double difference = 0;
    for (std::size_t i = 0; i < expected.size(); ++i)
        difference += std::abs(int{texture.rgba.data()[i]} - int{expected[i]});
    return difference / static_cast<double>(expected.size());
}

// Damaged pictures load or are refused by name, at least `refusals` of them.
[[maybe_unused]] void expectDamageIsRefused(const std::vector<Bytes>& pictures, const char* extension,
                                            int refusals) {
    std::mt19937 random(5);
    int refused = 0;
    for (int i = 0; i < 200; ++i)
        for (Bytes damaged : pictures) {
            for (int bytes = 0; bytes < 3; ++bytes)
                damaged[12 + random() % (damaged.size() - 12)] = static_cast<unsigned char>(random());
            if (i % 5 == 0) damaged.resize(12 + random() % (damaged.size() - 12));
            TexturedField field;
            field.texture["extensions"][extension]["source"] = field.image(damaged);
            const std::string error = loadError(field.file());
            if (error.empty()) continue;
            ++refused;
            expectMentions(error, {"test.glb", "image 0 (wall)"});
        }
    EXPECT_GT(refused, refusals);
}

#ifdef VCT_HAS_WEBP

Bytes encodeWebp(bool lossless) {
    const std::vector<std::uint8_t> rgba = picturePixels();
    std::uint8_t* encoded = nullptr;
    const std::size_t size = lossless ? WebPEncodeLosslessRGBA(rgba.data(), 16, 24, 64, &encoded)
                                      : WebPEncodeRGBA(rgba.data(), 16, 24, 64, 90, &encoded);
    const Bytes bytes(encoded, encoded + size);
    WebPFree(encoded);
    return bytes;
}

TEST(Webp, IsTheSamePicture) {
    for (const bool lossless : {true, false}) {
        TexturedField field;
        field.image(encodePng(4));
        field.texture = {{"source", 0}};
        field.texture["extensions"]["EXT_texture_webp"]["source"] = field.image(encodeWebp(lossless));
        field.builder.document["extensionsUsed"] = {"EXT_texture_webp"};
        // Lossless WebP changes colours of alpha 0 alone, and there are none.
        EXPECT_LE(differenceFromThePicture(load(field.file())), lossless ? 0.0 : 6.0);
    }
}

TEST(Webp, DamagedPicturesAreRefusedByName) {
    expectDamageIsRefused({encodeWebp(true), encodeWebp(false)}, "EXT_texture_webp", 80);
}

#else

TEST(Webp, IsRefusedByTheNameOfTheLibraryUnlessThereIsAFallback) {
    TexturedField field;
    field.texture["extensions"]["EXT_texture_webp"]["source"] =
        field.image(bytesOf(std::string("RIFF\x10\0\0\0WEBPVP8L", 16)));
    expectMentions(loadError(field.file()), {"test.glb", "image 0 (wall)", "libwebp", "VCT_WEBP"});
    field.texture["source"] = field.image(encodePng(4));
    EXPECT_EQ(load(field.file()).textures.at(0).width, 4);
}

#endif

TEST(Ktx2, IsRefusedUnlessThereIsAnotherImage) {
    TexturedField field;
    field.builder.document["extensionsRequired"] = {"KHR_texture_basisu"};
    field.texture["extensions"]["KHR_texture_basisu"]["source"] =
        field.image(bytesOf("\xABKTX 20\xBB\r\n\x1A\n"));
    expectMentions(loadError(field.file()), {"test.glb", "texture 0", "no PNG, JPEG or WebP image"});
    field.texture["source"] = field.image(encodePng(4));
    EXPECT_EQ(load(field.file()).textures.at(0).width, 4);
}

}  // namespace
}  // namespace vct::test
