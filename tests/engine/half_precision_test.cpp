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
#include "support/scenes.h"
#include "support/voxel_kinds.h"

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

// A closed room with a lamp below its ceiling, a box, and a metal floor that reflects the lamp. The pixels of
// the floor interpolate between reflections in half the resolution; those of the box trace their own.
Scene room(float lampRadiance) {
    Scene scene = closedBox(0.0);
    scene.materials[0].baseColor = glm::vec4(0.7F, 0.6F, 0.5F, 1.0F);
    scene.materials.resize(4, scene.materials[0]);
    scene.materials[1].metallic = 1.0F;
    scene.materials[1].roughness = 0.12F;
    scene.materials[2].roughness = 0.05F;
    scene.materials[3].emissive = glm::vec3(1.0F, 0.8F, 0.5F) * lampRadiance;
    scene.meshes[0].material = 1;
    addBox(scene, {0.6, 0.5, 0.6}, {-0.4, -0.75, -0.3}, 2);
    addQuad(scene, {-0.3, 0.9, -0.7}, {0.7, 0, 0}, {0, 0, 0.7}, 3);
    return finished(std::move(scene));
}

// The largest difference of a channel, relative to its value plus a tenth of the picture's mean.
double largestDifference(const Image& picture, const Image& expected) {
    double mean = 0.0, largest = 0.0;
    for (const glm::vec3& pixel : expected.pixels)
        mean += (pixel.x + pixel.y + pixel.z) / (3.0 * static_cast<double>(expected.pixels.size()));
    for (std::size_t i = 0; i < expected.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double right = expected.pixels[i][c];
            const double difference = std::abs(picture.pixels[i][c] - right) / (right + 0.1 * mean);
            largest = std::max(largest, std::isfinite(difference) ? difference : 1e9);
        }
    return largest;
}

struct MobileCase {
    const char* name;
    float lampRadiance;
    int cascades;
};

class HalfPrecisionOfMobile : public testing::TestWithParam<MobileCase> {};
// The bright lamp is as bright as half floats allow (radiance_unit.cpp).
INSTANTIATE_TEST_SUITE_P(Rooms, HalfPrecisionOfMobile,
                         testing::Values(MobileCase{"BrightLamp", 36000.0F, 1},
                                         MobileCase{"Cascades", 12.0F, 2}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(HalfPrecisionOfMobile, ChangesOnlyTheLowBits) {
    const Context context = openContext(Backend::egl);
    const Scene scene = room(GetParam().lampRadiance);
    Settings settings = smallPreset("mobile");
    settings.lightFrames = 4;
    settings.cascades = GetParam().cascades;
    const Camera camera = lookAt({0.5, 0.2, 0.95}, {0, -1, -0.2}, 90);
    const std::vector<Output> outputs = {Output::gi, Output::ao, Output::irradiance, Output::specularLight};
    // Mesa's llvmpipe computes mediump in 16 bits where the CPU has F16C, and rounds each operation.
    std::vector<Image> full, half;
    for (std::vector<Image>* pictures : {&full, &half}) {
        gl::Capabilities capabilities = context.capabilities;
        capabilities.softwareDriver = pictures == &full;  // this makes mediump highp
        Renderer renderer(scene, noLight(), settings, capabilities, testShaders());
        for (const Output output : outputs) {
            renderer.render({{output}, camera, LightSteps::all});
            pictures->push_back(renderer.radiance());
        }
    }
    if (half[0].pixels == full[0].pixels)
        GTEST_SKIP() << context.capabilities.renderer << " does not round mediump";
    for (std::size_t i = 0; i < outputs.size(); ++i)
        EXPECT_LE(largestDifference(half[i], full[i]), 0.01) << outputName(outputs[i]);
}

}  // namespace
}  // namespace vct::test
