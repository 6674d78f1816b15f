// mediump in 16 bits, as on Mali, changes only the low bits of a picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gl/read_back.h"
#include "lab/debug_view.h"
#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/renderers.h"
#include "support/voxels.h"

namespace vct::test {
namespace {

// A half has 11 significant bits, and a handful of operations cost three of them. Small values are
// differences of 1 and an opacity, so an error is relative to at least 1/16.
const double halfRelative = std::exp2(-8);
constexpr double smallest = 1.0 / 16.0;
// Share of the pixels that may differ by more: a cone ends at an opacity of 0.998, and rounding may decide
// when.
constexpr double halfFraction = 0.002;
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
    for (Output mode : allModes()) {
        renderer.render({{mode}, camera});
        pictures.images.push_back({outputName(mode), renderer.radiance(), true});
    }
    for (DebugView& part : lightParts(renderer, camera))
        pictures.images.push_back(std::move(part));
    for (int level = 0; level < renderer.packed()->occupancy().levels(); ++level)
        pictures.voxels.push_back(readVoxels(renderer.packed()->occupancy().texture(), level));
    return pictures;
}

// `isMode`: the 8 bits of a PNG are compared, too.
void expectLowBitsOnly(const DebugView& full, const DebugView& half, bool isMode) {
    double beyond = 0.0, largest = 0.0, largestPngSteps = 0.0;
    for (std::size_t i = 0; i < full.image.pixels.size(); ++i) {
        double relative = 0.0;
        for (int c = 0; c < 3; ++c) {
            const float a = full.image.pixels[i][c], b = half.image.pixels[i][c];
            const double steps = std::round(srgbEncode(a) * 255.0) - std::round(srgbEncode(b) * 255.0);
            relative = std::max(relative, std::abs(b - a) / std::max<double>(a, smallest));
            largest = std::max(largest, std::abs(b - a) / std::max<double>(a, 1.0));
            largestPngSteps = std::max(largestPngSteps, std::abs(steps));
        }
        beyond += relative > halfRelative ? 1.0 : 0.0;
    }
    EXPECT_LE(beyond, halfFraction * static_cast<double>(full.image.pixels.size())) << full.name;
    EXPECT_LE(largest, halfAbsolute) << full.name;
    if (isMode) {
        EXPECT_LE(largestPngSteps, maxPngSteps) << full.name;
    }
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
    ASSERT_EQ(full.images.size(), half.images.size());
    for (std::size_t i = 0; i < full.images.size(); ++i)
        expectLowBitsOnly(full.images[i], half.images[i], i < allModes().size());
    // Voxels are made in highp: every word, and so every level, is the same.
    EXPECT_EQ(full.voxels, half.voxels);
}

}  // namespace
}  // namespace vct::test
