// Bounces of light in closed rooms, where the equilibrium is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/directional/light_schedule.h"
#include "scene/camera.h"
#include "support/frame_inspector.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

// Without a sun, radiance is in the scene's unit.
Settings roomSettings(int lightFrames) {
    Settings settings = mobileAt(16);
    settings.shadowMapSize = 16;
    settings.lightFrames = lightFrames;
    return settings;
}

// Converged irradiance of the walls of a closed box of side 2: the mean and the largest of all faces.
struct WallIrradiance {
    double mean = 0.0, largest = 0.0;
};
WallIrradiance irradianceOfWalls(const Context& context, const Scene& scene, int steps) {
    FrameInspector frame(context, scene, noLight(), roomSettings(steps), lookAt({0, 0, 0.9}, {0, 0, -1}, 60));
    WallIrradiance result;
    double weights = 0.0;
    for (const auto& [entry, face] : frame.irradiance(true)) {
        const double light = face.light.g;
        EXPECT_TRUE(std::isfinite(light) && light >= 0.0);
        weights += face.coverage;
        result.mean += face.coverage * light;
        result.largest = std::max(result.largest, light);
    }
    result.mean /= weights;
    return result;
}

Scene furnace(float albedo, float emission) {
    Scene scene = closedBox(0.0);
    scene.materials[0].baseColor = glm::vec4(glm::vec3(albedo), 1.0F);
    scene.materials[0].emissive = glm::vec3(emission);
    return scene;
}

// An emitter of radiance 1 under the ceiling.
constexpr double patchSide = 0.5;
Scene roomWithLitPatch(float albedo) {
    Scene scene = furnace(albedo, 0.0F);
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].emissive = glm::vec3(1.0F);
    addQuad(scene, {-0.25, 0.98, -0.25}, {patchSide, 0, 0}, {0, 0, patchSide}, 1);
    scene = finished(std::move(scene));
    scene.boundsWorld = {glm::dvec3(-2.0), glm::dvec3(2.0)};  // 30 voxels along a wall
    return scene;
}

// A preset refines the light in further steps, each of which adds a bounce.
constexpr int presetFrames = 16 + 1024 / 8;
// Walls of emission 1 and albedo a receive 1 / (1 - a).
TEST(ClosedRoom, AFurnaceConvergesToItsEquilibrium) {
    const Context context = openContext(Backend::egl);
    const Settings mobile = presetSettings("mobile");
    ASSERT_EQ(LightSchedule(mobile.gather, mobile.lightFrames, mobile.cascades).convergenceSteps(),
              presetFrames);
    for (const float albedo : {0.0F, 0.9F}) {
        const WallIrradiance room = irradianceOfWalls(context, furnace(albedo, 1.0F), presetFrames);
        const double right = 1.0 / (1.0 - static_cast<double>(albedo));
        EXPECT_NEAR(room.mean / right, 1.0, 0.02) << albedo;
        EXPECT_LE(room.largest / right, 1.03) << albedo;
    }
}

// The walls absorb all light of an emitter: with the area W they receive A / W / (1 - albedo) of the radiance
// of an emitter of area A. Each step adds a bounce, and the presets' steps must suffice.
TEST(ClosedRoom, TheWallsAbsorbTheLightOfAnEmitterWithinThePresetsSteps) {
    const Context context = openContext(Backend::egl);
    const auto lit = [&](float albedo, int steps) {
        const double right = patchSide * patchSide / 24.0 / (1.0 - static_cast<double>(albedo));
        return irradianceOfWalls(context, roomWithLitPatch(albedo), steps).mean / right;
    };
    EXPECT_NEAR(lit(0.0F, presetFrames), 1.0, 0.06);
    const double few = lit(0.8F, presetFrames);
    EXPECT_NEAR(few, 1.0, 0.15);
    EXPECT_NEAR(few / lit(0.8F, 3 * presetFrames), 1.0, 0.025);
}

// White walls absorb nothing, so there is no equilibrium; the renderer bounds the light.
TEST(ClosedRoom, LightThatNothingAbsorbsIsBounded) {
    const Context context = openContext(Backend::egl);
    const double first = patchSide * patchSide / 24.0;
    const double times = irradianceOfWalls(context, roomWithLitPatch(1.0F), 3 * presetFrames).mean / first;
    EXPECT_LE(times, 1.12 / (1.0 - 0.99));
    EXPECT_GE(times, 3.0);
}

}  // namespace
}  // namespace vct::test
