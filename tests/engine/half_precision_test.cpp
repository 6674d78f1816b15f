// mediump in 16 bits, as on Mali, changes only the low bits of a picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gl/read_back.h"
#include "lab/cpu_mips.h"
#include "lab/debug_view.h"
#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/renderers.h"

namespace vct::test {
namespace {

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
    for (int level = 0; level < renderer.packed()->occupancy().levels(); ++level)
        pictures.voxels.push_back(readVoxels(renderer.packed()->occupancy().texture(), level));
    return pictures;
}

// The largest difference in steps of 1/255 as a PNG stores them.
double pngSteps(const Image& a, const Image& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            largest = std::max(largest, std::abs(std::round(srgbEncode(a.pixels[i][c]) * 255.0) -
                                                 std::round(srgbEncode(b.pixels[i][c]) * 255.0)));
    return largest;
}

class HalfPrecision : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Scenes, HalfPrecision, testing::Values("cornell", "courtyard"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(HalfPrecision, ChangesOnlyTheLowBits) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset(std::string(GetParam()) + ".glb"));
    gl::Capabilities capabilities = context.capabilities;
    capabilities.softwareDriver = true;  // this makes mediump highp
    const HalfPictures full = halfPicturesOf(capabilities, scene);
    // Mesa's llvmpipe computes mediump in 16 bits where the CPU has F16C, and rounds each operation.
    capabilities.softwareDriver = false;
    const HalfPictures half = halfPicturesOf(capabilities, scene);
    if (half.images[0].image.pixels == full.images[0].image.pixels)
        GTEST_SKIP() << context.capabilities.renderer << " does not round mediump";
    ASSERT_EQ(full.images.size(), half.images.size());
    for (std::size_t i = 0; i < full.images.size(); ++i)
        EXPECT_LE(pngSteps(full.images[i].image, half.images[i].image), 1.0) << full.images[i].name;
    // Voxelization is in highp, so every word is the same.
    EXPECT_EQ(full.voxels, half.voxels);
}

}  // namespace
}  // namespace vct::test
