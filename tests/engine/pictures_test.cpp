// Pictures, compared with goldens and between drivers. The preset thesis has all modes and debug views, the
// others have the modes that need voxels.
//
// VCT_UPDATE_GOLDENS=1 (scripts/update-goldens.sh) makes goldens; commit them with the reason after looking
// at them. They are llvmpipe's; other drivers are compared with llvmpipe's picture of the same run.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "image/compare.h"
#include "lab/debug_view.h"
#include "platform/contexts.h"
#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/every_test.h"
#include "support/renderers.h"

namespace vct::test {
namespace {

// Filament's two-number tolerance: a channel may differ by 5/255 anywhere, and by more in 0.1 % of the
// pixels.
constexpr float maxDifference = 5.0F / 255.0F;
constexpr double maxFraction = 0.001;

// The picture as a PNG stores it: encoded, clamped and rounded to 8 bits.
Image asPng(Image image) {
    for (glm::vec3& pixel : image.pixels)
        for (int c = 0; c < 3; ++c)
            pixel[c] = std::round(srgbEncode(pixel[c]) * 255.0F) / 255.0F;
    return image;
}

void expectAlike(const Image& a, const Image& b, const std::string& name) {
    const Difference difference = compareImages(a, b, maxDifference);
    EXPECT_TRUE(difference.comparable) << name << ": " << difference.reason;
    EXPECT_LE(difference.fraction, maxFraction) << name << ": largest difference " << difference.largest;
}

using Pictures = std::vector<std::pair<std::string, Image>>;

Pictures picturesOf(Backend backend, const std::string& sceneName, const std::string& preset) {
    const Context context = openContext(backend);
    const Scene scene = loadGltf(asset(sceneName + ".glb"));
    const bool thesis = preset == "thesis";
    Settings settings = presetSettings(preset);
    // Thin parts need the finer grids of the presets; shaders and numbers are the same on any grid.
    settings.grid = thesis ? 128 : 64;
    settings.size = glm::ivec2(200);
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), settings);
    const Camera camera = chooseCamera(scene, "");
    Pictures pictures;
    for (Output mode :
         thesis ? allModes() : std::vector<Output>{Output::ao, Output::gi, Output::giConeShadow}) {
        renderer.render({{mode}, camera, LightSteps::all});
        pictures.emplace_back(outputName(mode), renderer.radiance());
    }
    if (thesis)
        for (DebugView& stage : debugViews(renderer, camera))
            pictures.emplace_back("view_" + stage.name, std::move(stage.image));
    for (auto& [name, image] : pictures) {
        for (const glm::vec3& pixel : image.pixels)
            for (int c = 0; c < 3; ++c)
                EXPECT_TRUE(std::isfinite(pixel[c])) << name;
        image = asPng(std::move(image));
    }
    return pictures;
}

const auto scenes = testing::Values("cornell", "courtyard");
const auto presets = testing::Values("thesis", "mobile", "quality");

// The shaders of `quality` are those of `mobile`, and would take minutes on other drivers.
struct OtherPicture {
    Backend backend;
    const char* scene;
    const char* preset;
};
class OtherDriver : public testing::TestWithParam<OtherPicture> {};
INSTANTIATE_TEST_SUITE_P(Pictures, OtherDriver,
                         testing::Values(OtherPicture{Backend::osmesa, "courtyard", "thesis"},
                                         OtherPicture{Backend::osmesa, "cornell", "mobile"},
                                         OtherPicture{Backend::zink, "cornell", "thesis"},
                                         OtherPicture{Backend::zink, "courtyard", "mobile"}),
                         [](const auto& test) {
                             return std::string(backendName(test.param.backend)) + "_" + test.param.scene +
                                    "_" + test.param.preset;
                         });

TEST_P(OtherDriver, ModesAndDebugViewsAreWithinTolerance) {
    const auto [backend, scene, preset] = GetParam();
    VCT_SKIP_IF_ABSENT(backend);
    if (preset != std::string("thesis")) VCT_ONLY_AMONG_ALL();
    const Pictures reference = picturesOf(Backend::egl, scene, preset);
    const Pictures other = picturesOf(backend, scene, preset);
    ASSERT_EQ(reference.size(), other.size());
    for (std::size_t i = 0; i < reference.size(); ++i)
        expectAlike(reference[i].second, other[i].second, reference[i].first);
}

class Golden : public testing::TestWithParam<std::tuple<const char*, const char*>> {};
INSTANTIATE_TEST_SUITE_P(Pictures, Golden, testing::Combine(scenes, presets), [](const auto& test) {
    return std::string(std::get<0>(test.param)) + "_" + std::get<1>(test.param);
});

TEST_P(Golden, EveryModeAndDebugViewIsUnchanged) {
    {
        const Context context = openContext(Backend::egl);
        if (context.capabilities.renderer.find("llvmpipe") != 0)
            GTEST_SKIP() << "goldens are llvmpipe's; this machine's EGL gives "
                         << context.capabilities.renderer;
    }
    const auto [scene, preset] = GetParam();
    if (preset == std::string("quality")) VCT_ONLY_AMONG_ALL();
    const std::string folder = std::string(VCT_SOURCE_DIR "/tests/golden/") + scene +
                               (preset == std::string("thesis") ? "" : std::string("/") + preset);
    const bool update = std::getenv("VCT_UPDATE_GOLDENS") != nullptr;
    if (update) std::filesystem::create_directories(folder);
    for (const auto& [name, image] : picturesOf(Backend::egl, scene, preset)) {
        const std::string file = folder + "/" + name + ".png";
        if (update) {
            Image linear = image;
            for (glm::vec3& pixel : linear.pixels)
                for (int c = 0; c < 3; ++c)
                    pixel[c] = srgbDecode(pixel[c]);
            writePng(file, linear);
        }
        expectAlike(asPng(readImage(file)), image, file);
    }
}

// The shift of a picture, which anti-aliasing uses for parts of a pixel, is exact for whole pixels.
TEST(PictureShift, ByWholePixelsMovesThePictureAndKeepsTheLight) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("contact.glb"));
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), mobileAt(64));
    const Camera front = chooseCamera(scene, "");
    renderer.render({{Output::gi}, front, LightSteps::all});
    const Image still = renderer.radiance();
    renderer.setPictureShift({3.0F, 2.0F});
    renderer.render({{Output::gi}, front});
    const Image moved = renderer.radiance();
    int different = 0;
    for (int y = 2; y < 64; ++y)
        for (int x = 0; x < 61; ++x)
            different += glm::length(moved.at(x + 3, y - 2) - still.at(x, y)) > 2e-3F;
    EXPECT_LT(different, 20);  // Edges whose rounding differs.
    renderer.setPictureShift({0.0F, 0.0F});
    renderer.render({{Output::gi}, front});
    EXPECT_EQ(renderer.radiance().pixels, still.pixels);
}

}  // namespace
}  // namespace vct::test
