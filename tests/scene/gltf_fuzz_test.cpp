// Damaged files either load or end in a vct::Error, which the sanitizers check best.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.h"
#include "support/errors.h"
#include "support/gltf_builder.h"

namespace vct::test {
namespace {

Bytes validFile(const Bytes& image) {
    GltfBuilder b = completeFile(image);
    json& material = b.document["materials"][0];
    material["alphaMode"] = "MASK";
    material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
        {"rotation", 1}};
    b.document["meshes"][0]["primitives"][0]["mode"] = 5;  // a strip
    b.animate(0, "translation", {0, 1}, {9, 9, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 9, 9, 9},
              "CUBICSPLINE");
    return b.glb();
}

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// The renderer relies on this in every scene that loads.
void checkScene(const Scene& scene) {
    ASSERT_GT(scene.triangleCount(), 0U);
    for (const Mesh& mesh : scene.meshes) {
        ASSERT_LT(static_cast<std::size_t>(mesh.material), scene.materials.size());
        for (const std::uint32_t index : mesh.indices)
            ASSERT_LT(index, mesh.vertices.size());
        for (const Vertex& vertex : mesh.vertices) {
            ASSERT_TRUE(finite(vertex.position));
            ASSERT_NEAR(glm::length(vertex.normal), 1.0F, 1e-4F);
            ASSERT_TRUE(std::isfinite(vertex.uv.x + vertex.uv.y + vertex.emissiveUv.x + vertex.emissiveUv.y));
        }
    }
    for (const Material& material : scene.materials) {
        ASSERT_LT(material.baseColorTexture, static_cast<int>(scene.textures.size()));
        ASSERT_LT(material.emissiveTexture, static_cast<int>(scene.textures.size()));
    }
    for (const Texture& texture : scene.textures)
        ASSERT_EQ(texture.rgba.size(), static_cast<std::size_t>(texture.width) * texture.height * 4U);
    ASSERT_TRUE(finite(glm::vec3(scene.boundsWorld.max - scene.boundsWorld.min)));
    for (const double seconds : {0.0, 0.5, 1e9})
        for (const glm::dmat4& worldFromNode : poseAt(scene.animation, seconds).worldFromNode)
            ASSERT_TRUE(finite(glm::vec3(worldFromNode * glm::dvec4(1.0))));
}

enum class Outcome { loaded, refused };

Outcome tryLoad(const Bytes& file) {
    try {
        checkScene(load(file));
        return Outcome::loaded;
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        expectMentions(error.what(), {"test.glb"});
        return Outcome::refused;
    }
}

class GltfFuzz : public ::testing::TestWithParam<const char*> {
  protected:
    Bytes file() const {
        return validFile(std::string(GetParam()) == "png" ? encodePng(12) : encodeJpeg(24));
    }
};

TEST_P(GltfFuzz, EveryTruncationIsRefused) {
    const Bytes whole = file();
    ASSERT_EQ(tryLoad(whole), Outcome::loaded);
    for (std::size_t size = 0; size < whole.size(); size += size < 64 ? 1 : 7)
        EXPECT_EQ(tryLoad(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))),
                  Outcome::refused)
            << size;
}

TEST_P(GltfFuzz, FlippedBitsNeverCrash) {
    // The decoder reads tables that a damaged file leaves uninitialized, so it may crash.
    if (std::string(GetParam()) == "jpeg")
        GTEST_SKIP()
            << "stb_image 2.27, which Debian has, reads beyond its tables in damaged JPEGs; 2.28 does not";
    const Bytes whole = file();
    std::mt19937 random(2016);
    int loaded = 0;
    constexpr int variants = 2000;
    for (int i = 0; i < variants; ++i) {
        Bytes damaged = whole;
        const unsigned flips = 1 + random() % 4;
        for (unsigned flip = 0; flip < flips; ++flip)
            damaged[random() % damaged.size()] ^= static_cast<unsigned char>(1U << (random() % 8));
        loaded += tryLoad(damaged) == Outcome::loaded ? 1 : 0;
        ASSERT_FALSE(HasFatalFailure()) << "variant " << i;
    }
    EXPECT_GT(loaded, 0);  // else only the outer layers were tested
    EXPECT_LT(loaded, variants);
}

// Flipped bits mostly break the syntax of the JSON. Digits and bytes of images reach the code behind it.
TEST_P(GltfFuzz, ChangedDigitsAndImageBytesNeverCrash) {
    const Bytes whole = file();
    std::vector<std::size_t> digits;
    std::size_t jsonSize = 0;
    for (std::size_t i = 0; i < 4; ++i)
        jsonSize |= static_cast<std::size_t>(whole[12 + i]) << (8 * i);
    for (std::size_t i = 20; i < 20 + jsonSize; ++i) {
        if (whole[i] >= '0' && whole[i] <= '9') digits.push_back(i);
    }
    std::mt19937 random(310);
    for (int i = 0; i < 2000; ++i) {
        Bytes damaged = whole;
        for (int change = 0; change < 2; ++change) {
            if (i % 2 == 0) {
                damaged[digits[random() % digits.size()]] = static_cast<unsigned char>('0' + random() % 10);
            } else {
                const std::size_t binary = 20 + jsonSize + 8;
                damaged[binary + random() % (damaged.size() - binary)] = static_cast<unsigned char>(random());
            }
        }
        tryLoad(damaged);
        ASSERT_FALSE(HasFatalFailure()) << "variant " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Image, GltfFuzz, ::testing::Values("png", "jpeg"),
                         [](const auto& kind) { return std::string(kind.param); });

}  // namespace
}  // namespace vct::test
