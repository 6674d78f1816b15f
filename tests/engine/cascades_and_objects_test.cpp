// Objects that move, or could, in nested cubes of voxels: what a step of light visits, and what it ends with.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/settings.h"
#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/moving_scenes.h"
#include "support/renderers.h"

namespace vct::test {
namespace {

// A yard of 16 m x 16 m behind walls of 3 m. A red box slides along the white wall on the left.
Scene yardWithABox() {
    GltfBuilder builder = openFloor();
    const std::vector<float> white{0.8F, 0.8F, 0.8F};
    const auto addWall = [&](const std::vector<double>& size, const std::vector<double>& middle) {
        addCube(builder, white, {{"scale", size}, {"translation", middle}});
    };
    addWall({16, 0.2, 16}, {0, -0.2, 0});
    for (const double side : {-8.0, 8.0}) {
        addWall({0.4, 3, 16}, {side, 1.5, 0});
        addWall({16, 3, 0.4}, {0, 1.5, side});
    }
    const int box =
        addCube(builder, {0.8F, 0.1F, 0.1F}, {{"scale", {3, 2.4, 1}}, {"translation", {-5, 1.2, -7.2}}});
    builder.animate(box, "translation", {0, 1}, {-5, 1.2F, -7.2F, 5, 1.2F, -7.2F});
    return load(builder);
}

class WalkInTheYard {
  public:
    explicit WalkInTheYard(const Context& context)
        : context_(context), scene_(yardWithABox()), walking_(makeOf(scene_)) {}

    // Renders a frame at a time of the animation from a camera at `x`, in metres.
    void step(double seconds, double x, LightSteps steps = LightSteps::one) {
        walking_.setPose(poseAt(scene_.animation, seconds));
        walking_.render({{Output::irradiance}, cameraAt(x), steps});
    }
    // The mean difference of what it shows from what a new renderer does, relative to that.
    double differenceFromNew(double seconds, double x) {
        Renderer fresh = makeOf(frozenAt(scene_, seconds));
        fresh.render({{Output::irradiance}, cameraAt(x), LightSteps::all});
        const Image shown = walking_.radiance(), right = fresh.radiance();
        double difference = 0.0, sum = 0.0;
        for (std::size_t i = 0; i < right.pixels.size(); ++i) {
            difference += std::abs(double{shown.pixels[i].y} - double{right.pixels[i].y});
            sum += right.pixels[i].y;
        }
        EXPECT_GT(sum, 0.01);
        return difference / sum;
    }
    // The number of faces in the list of those that steps visit, relative to all.
    double visitedShare() {
        const shared::CommandLists found = walking_.directional()->voxels().index().readCommands();
        return static_cast<double>(found.lists[VCT_LIST_VISITED].faceCount) /
               static_cast<double>(walking_.directional()->voxels().readBaseFaces().size());
    }

  private:
    Renderer makeOf(const Scene& scene) const {
        Settings settings = mobileAt(64);
        settings.cascades = 3;
        return makeRenderer(context_, scene, chooseLight(scene), settings);
    }
    static Camera cameraAt(double x) { return lookAt({x, 1.5, 2}, {0, 1, -8}, 70); }

    const Context& context_;
    Scene scene_;
    Renderer walking_;
};

// While something changes, each step visits some of the cascades. None may keep the light of an earlier pose.
TEST(CascadesAndObjects, ShowTheLightOfANewRendererOnceNothingMoves) {
    const Context context = openContext(Backend::egl);
    WalkInTheYard walk(context);
    walk.step(0.0, -2.0, LightSteps::all);
    EXPECT_LE(walk.differenceFromNew(0.0, -2.0), 0.01);
    double seconds = 0.0, x = -2.0;
    for (int frame = 1; frame <= 8; ++frame)
        walk.step(seconds += 0.05, x += 0.15);
    // Around the box the light follows at once.
    EXPECT_LE(walk.differenceFromNew(seconds, x), 0.034);
    walk.step(seconds += 0.5, x);
    walk.step(seconds, x, LightSteps::all);
    EXPECT_LE(walk.differenceFromNew(seconds, x), 0.01);
}

// A scene pays for what has changed, and not for an object that could move.
TEST(CascadesAndObjects, AreVisitedWhereTheyChange) {
    const Context context = openContext(Backend::egl);
    WalkInTheYard walk(context);
    walk.step(0.0, -2.0, LightSteps::all);
    double inMoves = 0.0, inPoses = 0.0;
    for (int frame = 1; frame <= 8; ++frame) {
        walk.step(0.0, -2.0 + 0.1 * frame);
        inMoves = std::max(inMoves, walk.visitedShare());
    }
    walk.step(0.0, -1.2, LightSteps::all);
    for (int frame = 1; frame <= 4; ++frame) {
        walk.step(0.1 * frame, -1.2);
        inPoses = std::max(inPoses, walk.visitedShare());
    }
    EXPECT_GT(inMoves, 0.01);
    EXPECT_LE(inMoves, 0.4);
    EXPECT_GT(inPoses, 0.01);
    EXPECT_LE(inPoses, 0.8);
}

}  // namespace
}  // namespace vct::test
