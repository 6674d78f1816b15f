#include "support/playing_scene.h"

#include <gtest/gtest.h>

#include "support/face_irradiance.h"
#include "support/grids.h"

namespace vct::test {

Camera PlayingScene::moveTo(double seconds) {
    const Pose pose = poseAt(scene_.animation, seconds);
    renderer_.setPose(pose);
    renderer_.setLightDirection(posed(chooseLight(scene_), pose).directionToLight);
    return posed(chooseCamera(scene_, ""), pose);
}

void PlayingScene::frameAt(double seconds, Output mode) {
    renderer_.render({{mode}, moveTo(seconds)});
}

void PlayingScene::drawTwiceAt(double seconds, Output mode) {
    frameAt(seconds, mode);
    gl::Finish();
    frameAt(seconds, mode);
}

void PlayingScene::convergedAt(double seconds, Output mode) {
    renderer_.render({{mode}, moveTo(seconds), LightSteps::all});
}

void expectFresh(PlayingScene& stage, const Context& context, const Scene& scene, const Settings& settings,
                 double seconds, Output mode) {
    const std::string what = std::to_string(seconds) + " s, " + outputName(mode);
    stage.drawTwiceAt(seconds, mode);
    const Scene frozen = frozenAt(scene, seconds);
    PlayingScene fresh(context, frozen, settings);
    fresh.frame(mode);
    expectSameGrid(gridOf(stage.renderer()), gridOf(fresh.renderer()), what);
    const DirectionalVolume* directional = stage.renderer().directional();
    if (directional == nullptr || directional->irradiance() == nullptr)
        expectSamePicture(stage.renderer().radiance(), fresh.renderer().radiance(), what);
}

void expectFreshLight(PlayingScene& stage, const Context& context, const Scene& scene,
                      const Settings& settings, double seconds, Output mode) {
    const std::string what = std::to_string(seconds) + " s, " + outputName(mode);
    stage.convergedAt(seconds, mode);
    const Scene frozen = frozenAt(scene, seconds);
    PlayingScene fresh(context, frozen, settings);
    fresh.convergedAt(0.0, mode);
    const IrradianceByFace now = readIrradiance(stage.renderer()), right = readIrradiance(fresh.renderer());
    ASSERT_EQ(now.size(), right.size()) << what;
    const IrradianceDifference d = differenceOf(now, right);
    EXPECT_GT(d.common, right.size() / 2) << what;
    EXPECT_LE(d.rms, 0.06 * d.mean) << what;
    // Single faces beside an object differ, whose rays begin at the static plane alone.
    EXPECT_LE(d.largest, 3.0 * d.mean) << what;
}

}  // namespace vct::test
