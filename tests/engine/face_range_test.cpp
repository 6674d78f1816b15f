// The range of the faces' radiance, which the GPU measures: it fits every scene, converges with the light and
// follows lights that are switched.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/faces.h"
#include "support/renderers.h"

namespace vct::test {
namespace {

double rangeOf(const Renderer& renderer) {
    shared::FaceRange range{};
    renderer.directional()->voxels().range().read(&range, sizeof range);
    return range.radiance;
}

double meanOf(const Image& image) {
    double sum = 0.0;
    for (const glm::vec3& pixel : image.pixels)
        sum += pixel.r + pixel.g + pixel.b;
    return sum / static_cast<double>(3 * image.pixels.size());
}

// At most half a power of two of the 8 bits is unused, and nothing is clipped.
TEST(FaceRange, FitsTheBrightestFace) {
    const Context context = openContext(Backend::egl);
    for (const char* name : {"cornell", "night", "dim_room"}) {
        const Scene scene = loadGltf(asset(std::string(name) + ".glb"));
        Renderer renderer = makeRenderer(context, scene, chooseLight(scene), mobileAt(16));
        renderer.render({{Output::gi}, chooseCamera(scene, ""), LightSteps::all});
        const FaceLevel base = readFaceLevel(renderer.directional()->voxels(), 0);
        int largest = 0;
        base.forEachVoxel([&](const glm::ivec3& voxel) {
            for (int face = 0; face < faceCount; ++face) {
                const glm::u8vec4& value = base.at(voxel, face);
                largest = std::max({largest, int{value.r}, int{value.g}, int{value.b}});
            }
        });
        EXPECT_GT(largest, 128) << name;
        EXPECT_LT(largest, 250) << name;
    }
}

// The range of a step is that of the light before it. A light that is switched on is clipped for a step, and
// the step after it is switched off uses few of the 8 bits. Neither may show as a flash.
TEST(FaceRange, NoFrameIsBrighterOrDarkerThanTheLightBeforeAndAfterASwitch) {
    const Context context = openContext(Backend::egl);
    Scene scene = loadGltf(asset("night.glb"));
    for (PunctualLight& light : scene.punctualLights)
        light.intensity *= 30.0F;
    const Camera camera = chooseCamera(scene, "");
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), mobileAt(64));
    const auto switchAll = [&](bool on) {
        for (std::size_t light = 0; light < scene.punctualLights.size(); ++light)
            renderer.setLightOn(light, on);
    };
    const auto converged = [&] {
        renderer.render({{Output::indirectLight}, camera, LightSteps::all});
        return meanOf(renderer.radiance());
    };
    const double on = converged(), rangeOn = rangeOf(renderer);
    switchAll(false);
    const double off = converged(), rangeOff = rangeOf(renderer);
    ASSERT_LT(off, 0.5 * on);
    ASSERT_LT(rangeOff, 0.5 * rangeOn);
    for (const bool lit : {true, false, true}) {
        SCOPED_TRACE(lit ? "on" : "off");
        switchAll(lit);
        double last = lit ? off : on;
        for (int frame = 0; frame < 32; ++frame) {
            renderer.render({{Output::indirectLight}, camera});
            const double now = meanOf(renderer.radiance());
            EXPECT_GT(now, 0.98 * std::min(lit ? on : off, last)) << "frame " << frame;
            EXPECT_LT(now, 1.02 * std::max(lit ? on : off, last)) << "frame " << frame;
            last = now;
        }
        EXPECT_NEAR(last, lit ? on : off, 0.03 * on);
        EXPECT_NEAR(std::log2(rangeOf(renderer) / (lit ? rangeOn : rangeOff)), 0.0, 0.6);
    }
}

}  // namespace
}  // namespace vct::test
