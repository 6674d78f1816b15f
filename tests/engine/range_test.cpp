// Light of any strength: pictures scale with it, as half floats do not limit them.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/renderer.h"
#include "scene/camera.h"
#include "support/punctual_light.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

constexpr double strengths[] = {1e-4, 1e2, 1e5, 1e8};

double meanOf(const Context& context, const Scene& scene, const DirectionalLight& light,
              const Settings& settings) {
    Renderer renderer = makeRenderer(context, scene, light, settings);
    renderer.render({{Output::gi}, lookAt({0.3, 0.2, 0.9}, {0, -0.3, -1}, 75.0), LightSteps::all});
    double sum = 0.0;
    const Image image = renderer.radiance();
    for (const glm::vec3& pixel : image.pixels)
        sum += pixel.y;
    return sum / static_cast<double>(image.pixels.size());
}

// `meanAt`: the mean radiance with light of a strength.
template <class MeanAt>
void expectProportional(const MeanAt& meanAt) {
    const double unit = meanAt(1.0);
    EXPECT_GT(unit, 0.0);
    for (const double strength : strengths)
        EXPECT_NEAR(meanAt(strength) / strength, unit, 0.01 * unit) << "strength " << strength;
}

class Range : public testing::Test {
  protected:
    const Context context_ = openContext(Backend::egl);
    Settings settings_ = mobileAt(32);
};

TEST_F(Range, APictureIsProportionalToTheLightThatSurfacesEmit) {
    expectProportional([&](double strength) {
        Scene scene = closedBox(0.0);
        scene.materials.push_back(scene.materials[0]);
        scene.materials.back().emissive = glm::vec3(static_cast<float>(strength));
        addQuad(scene, {-0.3, 0.9, -0.3}, {0.6, 0, 0}, {0, 0, 0.6}, 1);
        return meanOf(context_, finished(std::move(scene)), noLight(), settings_);
    });
}

TEST_F(Range, APictureIsProportionalToTheSky) {
    expectProportional([&](double strength) {
        settings_.skyRadiance = glm::vec3(static_cast<float>(strength));
        return meanOf(context_, lonePlane(0.0), noLight(), settings_);
    });
}

TEST_F(Range, APictureIsProportionalToALamp) {
    expectProportional([&](double strength) {
        Scene scene = closedBox(0.0);
        scene.punctualLights.push_back(
            punctualLightAt(PunctualLight::Type::point, {0.2, 0.5, 0.1}, {0, 0, 0}));
        scene.punctualLights.back().intensity = static_cast<float>(strength);
        return meanOf(context_, scene, noLight(), settings_);
    });
}

// The emitter is outside of the picture, and does not reach the floor.
TEST_F(Range, AStrongEmitterLeavesTheSunlightAsItIs) {
    double before = 0.0;
    for (const double strength : {1.0, 1e6}) {
        Scene scene = lonePlane(0.0);
        scene.materials.push_back(scene.materials[0]);
        scene.materials.back().emissive = glm::vec3(static_cast<float>(strength));
        addQuad(scene, {-0.1, -0.5, -0.1}, {0.2, 0, 0}, {0, 0, 0.2}, 1);  // below the floor, facing down
        Renderer renderer =
            makeRenderer(context_, finished(std::move(scene)), lightFrom({0.1, 1, 0.2}), settings_);
        renderer.render({{Output::gi}, lookAt({0, 1, 0.5}, {0, 0, 0}, 30.0), LightSteps::all});
        const double seen = renderer.radiance().at(16, 16).x;
        EXPECT_GT(seen, 0.5);
        if (before > 0.0) {
            EXPECT_NEAR(seen, before, 0.01 * before);
        }
        before = seen;
    }
}

}  // namespace
}  // namespace vct::test
