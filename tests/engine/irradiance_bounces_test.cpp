// Light that goes round in closed rooms, where the balance is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "scene/camera.h"
#include "support/gathered_frame.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

// In the dark: radiance is in the scene's unit.
Settings settingsOf(const char* preset, int lightFrames) {
    Settings settings = presetSettings(preset);
    settings.size = glm::ivec2(16);
    settings.shadowMapSize = 16;
    settings.lightFrames = lightFrames;
    return settings;
}

// What the walls of a closed box of side 2 received when their light stands still: mean radiance over the
// hemisphere, and the mean over all faces.
class Room {
  public:
    Room(const Context& context, const Scene& scene, const Settings& settings)
        : frame_(context, scene, noLight(), settings, volumeAround(scene.boundsWorld, settings.grid),
                 lookAt({0, 0, 0.9}, {0, 0, -1}, 60)) {
        frame_.settle(true);
        const FaceLevel base = frame_.levels()[0];
        double weights = 0.0;
        for (const auto& [entry, face] : frame_.received()) {
            const double weight = base.at(glm::ivec3(shared::unpackFaceVoxel(entry)),
                                          static_cast<int>(shared::unpackFace(entry)))
                                      .a;
            const double received = face.light.g * frame_.uniforms().radianceRange;
            weights += weight;
            mean_ += weight * received;
            largest_ = std::max(largest_, received);
            EXPECT_TRUE(std::isfinite(received) && received >= 0.0);
        }
        mean_ /= weights;
    }
    double mean() const { return mean_; }
    double largest() const { return largest_; }

  private:
    GatheredFrame frame_;
    double mean_ = 0.0, largest_ = 0.0;
};

Scene furnace(float albedo, float emission) {
    Scene scene = closedBox(0.0);
    scene.materials[0].baseColor = glm::vec4(glm::vec3(albedo), 1.0F);
    scene.materials[0].emissive = glm::vec3(emission);
    return scene;
}

// A lamp of radiance 1 under the ceiling.
constexpr double lampSide = 0.5;
Scene roomWithLamp(float albedo) {
    Scene scene = furnace(albedo, 0.0F);
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].emissive = glm::vec3(1.0F);
    addQuad(scene, {-0.25, 0.98, -0.25}, {lampSide, 0, 0}, {0, 0, lampSide}, 1);
    return finished(std::move(scene));
}

// The preset `quality` has the same shaders, and takes minutes for these rooms; its goldens hold it.
class ClosedRoom : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Presets, ClosedRoom, testing::Values("mobile"),
                         [](const auto& test) { return std::string(test.param); });

constexpr int lightFrames = 16;  // the presets'
// Of jni/engine/directional/irradiance.cpp: what faces send on makes up for what cones lose.
constexpr double bounceGain = 1.06;

// What goes round is known where all walls are alike: of emission e and albedo a, each of which receives the
// share g of what the others send, they receive e g / (1 - a g). Of what is right, where g is 1, cones that
// end early and meet the gaps of walls cost some more in each bounce.
TEST_P(ClosedRoom, AFurnaceComesToItsBalance) {
    const Context context = openContext(Backend::egl);
    ASSERT_EQ(presetSettings(GetParam()).lightFrames, lightFrames);
    double share = 0.0;
    for (const float albedo : {0.0F, 0.5F, 0.8F, 0.9F}) {
        const Scene scene = furnace(albedo, 1.0F);
        const Room room(context, scene, settingsOf(GetParam(), lightFrames));
        const double a = albedo, right = 1.0 / (1.0 - a);
        if (albedo == 0.0F) share = room.mean();
        const double balance = share / (1.0 - a * bounceGain * share);
        std::printf("%s, albedo %.1f: %.3f of what is right, up to %.3f; %.3f of the balance\n", GetParam(),
                    albedo, room.mean() / right, room.largest() / right, room.mean() / balance);
        EXPECT_NEAR(share, 1.0, 0.07);
        EXPECT_NEAR(room.mean() / balance, 1.0, 0.04) << albedo;
        EXPECT_LE(room.largest() / right, 1.1) << albedo;
    }
}

// Light that goes round needs many steps to come to its balance, each of which adds a bounce; a few must do.
TEST_P(ClosedRoom, TheBalanceIsReachedInFewSteps) {
    const Context context = openContext(Backend::egl);
    for (const Scene& scene : {furnace(0.8F, 1.0F), roomWithLamp(0.8F)}) {
        const auto meanAfter = [&](int steps) {
            Settings settings = settingsOf(GetParam(), steps);
            settings.grid = 32;  // what is slow, bounces, is as slow there
            return Room(context, scene, settings).mean();
        };
        const double few = meanAfter(lightFrames), many = meanAfter(10 * lightFrames);
        std::printf("%s: %.4f after %d steps, %.4f after %d\n", GetParam(), few, lightFrames, many,
                    10 * lightFrames);
        EXPECT_NEAR(few / many, 1.0, 0.025);
    }
}

// All that a lamp of area A sends is absorbed by the walls: of an area W, they receive A / W / (1 - albedo)
// of its radiance; less what is lost in each bounce, as above.
TEST_P(ClosedRoom, WhatALampSendsIsAbsorbed) {
    const Context context = openContext(Backend::egl);
    const auto lit = [&](float albedo) {
        const Room room(context, roomWithLamp(albedo), settingsOf(GetParam(), lightFrames));
        const double right = lampSide * lampSide / 24.0 / (1.0 - static_cast<double>(albedo));
        std::printf("%s, lamp, albedo %.1f: %.3f of what is right\n", GetParam(), albedo,
                    room.mean() / right);
        return room.mean() / right;
    };
    EXPECT_NEAR(lit(0.0F), 1.0, 0.06);
    EXPECT_NEAR(lit(0.5F), 1.0, 0.1);
    EXPECT_NEAR(lit(0.8F), 1.0, 0.15);
}

// Nothing absorbs anything: there is no balance, and yet a bound, largestBounceShare()'s.
TEST_P(ClosedRoom, LightThatNothingAbsorbsIsBounded) {
    const Context context = openContext(Backend::egl);
    const double first = lampSide * lampSide / 24.0;
    for (const int steps : {8, 32, 128}) {
        Settings settings = settingsOf(GetParam(), steps);
        settings.grid = 32;
        const Room room(context, roomWithLamp(1.0F), settings);
        std::printf("%s, albedo 1, %d steps: %.2f times the first bounce\n", GetParam(), steps,
                    room.mean() / first);
        EXPECT_LE(room.mean() / first, 1.1 / (1.0 - 0.95));
        EXPECT_GE(room.mean() / first, 3.0);
    }
}

}  // namespace
}  // namespace vct::test
