// mediump computed in 16 bits, as Mali does: nothing but the low bits of a picture may change.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lab/debug_view.h"
#include "lab/read_back.h"
#include "scene/camera.h"
#include "support/renderers.h"
#include "support/voxels.h"

namespace vct::test {
namespace {

// A half has 11 significant bits; a handful of operations cost three of them. Small values are what opacity
// leaves of 1, so a difference is relative to at least 1/16.
const double halfRelative = std::exp2(-8);
constexpr double smallest = 1.0 / 16.0;
constexpr double halfFraction = 0.002;  // of the pixels may differ by more: a cone is done at 0.998, so where
                                        // rounding decides whether it is, 0.002 of light is at stake
const double halfAbsolute = std::exp2(-8);  // of a value up to 1, anywhere
constexpr double maxPngSteps = 1.0;         // of 255, anywhere in the five modes

struct HalfPictures {
    std::vector<DebugView> images;
    std::vector<Words> voxels;
};

HalfPictures halfPicturesOf(const gl::Capabilities& capabilities, const Scene& scene) {
    Settings settings = smallSettings(64, 96);
    settings.skyRadiance = glm::vec3(0.1F, 0.15F, 0.3F);
    Renderer renderer(scene, chooseLight(scene), settings, capabilities, testShaders());
    const Camera camera = chooseCamera(scene, "");
    HalfPictures pictures;
    for (Mode mode : allModes()) {
        renderer.frame(mode, camera);
        pictures.images.push_back({modeName(mode), renderer.radiance(), true});
    }
    for (DebugView& part : lightParts(renderer, camera))
        pictures.images.push_back(std::move(part));
    for (int level = 0; level < renderer.packed()->occupancy().levels(); ++level)
        pictures.voxels.push_back(readVoxels(renderer.packed()->occupancy().texture(), level));
    return pictures;
}

struct HalfDifference {
    std::size_t changed = 0;  // pixels
    std::size_t beyond = 0;   // pixels
    double largest = 0.0;
    double largestPngSteps = 0.0;
};

HalfDifference halfDifferenceOf(const Image& full, const Image& half) {
    HalfDifference result;
    for (std::size_t i = 0; i < full.pixels.size(); ++i) {
        double relative = 0.0;
        for (int c = 0; c < 3; ++c) {
            const float a = full.pixels[i][c];
            const float b = half.pixels[i][c];
            relative = std::max(relative, std::abs(b - a) / std::max<double>(a, smallest));
            result.largest = std::max(result.largest, std::abs(b - a) / std::max<double>(a, 1.0));
            const double steps =
                std::abs(std::round(srgbEncode(a) * 255.0) - std::round(srgbEncode(b) * 255.0));
            result.largestPngSteps = std::max(result.largestPngSteps, steps);
        }
        result.changed += relative > 0.0 ? 1 : 0;
        result.beyond += relative > halfRelative ? 1 : 0;
    }
    return result;
}

void expectLowBitsOnly(const HalfPictures& full, const HalfPictures& half) {
    ASSERT_EQ(full.images.size(), half.images.size());
    std::size_t changed = 0;
    for (std::size_t i = 0; i < full.images.size(); ++i) {
        const std::string& name = full.images[i].name;
        const HalfDifference d = halfDifferenceOf(full.images[i].image, half.images[i].image);
        const auto pixels = static_cast<double>(full.images[i].image.pixels.size());
        std::printf("%-18s changed %4.1f %%, beyond 2^-8 %.3f %%, largest 2^%.1f, %g of 255\n", name.c_str(),
                    100.0 * static_cast<double>(d.changed) / pixels,
                    100.0 * static_cast<double>(d.beyond) / pixels, std::log2(d.largest), d.largestPngSteps);
        EXPECT_LE(static_cast<double>(d.beyond), halfFraction * pixels) << name;
        EXPECT_LE(d.largest, halfAbsolute) << name;
        if (i < allModes().size()) {
            EXPECT_LE(d.largestPngSteps, maxPngSteps) << name;
        }
        changed += d.changed;
    }
    EXPECT_GT(changed, 0U) << "nothing was rounded";
    // Voxels are made in highp: every word, and so every level, is the same.
    EXPECT_EQ(full.voxels, half.voxels);
}

class HalfPrecision : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Scenes, HalfPrecision, testing::Values("cornell", "courtyard"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(HalfPrecision, ChangesOnlyTheLowBits) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset(std::string(GetParam()) + ".glb"));
    gl::Capabilities capabilities = context.capabilities;
    capabilities.softwareDriver = true;  // mediump is highp then
    const HalfPictures full = halfPicturesOf(capabilities, scene);
    // Mesa's llvmpipe computes mediump in 16 bits where the CPU has F16C, and rounds each operation.
    capabilities.softwareDriver = false;
    const HalfPictures half = halfPicturesOf(capabilities, scene);
    if (half.images[0].image.pixels == full.images[0].image.pixels)
        GTEST_SKIP() << context.capabilities.renderer << " does not round mediump";
    expectLowBitsOnly(full, half);
}

}  // namespace
}  // namespace vct::test
