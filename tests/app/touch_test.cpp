// Touches become gestures, and gestures change the view.
#include <gtest/gtest.h>

#include "app/orbit_view.h"
#include "app/touch.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

using app::Gesture;
using app::OrbitView;
using app::Touch;

using Points = std::vector<app::TouchPoint>;

TEST(Touch, OneFingerOrbitsOnceItHasMoved) {
    Touch touch(1.0F);
    touch.update({{0, {100, 100}}}, 0.0);
    touch.update({{0, {103, 100}}}, 0.1);
    EXPECT_EQ(touch.take().orbit, glm::vec2(0.0F)) << "a tap trembles";
    touch.update({{0, {120, 90}}}, 0.2);
    touch.update({{0, {125, 90}}}, 0.3);
    EXPECT_EQ(touch.take().orbit, glm::vec2(25, -10));
    touch.update({}, 0.4);
    const Gesture after = touch.take();
    EXPECT_EQ(after.orbit, glm::vec2(0.0F));
    EXPECT_FALSE(after.doubleTap);
}

TEST(Touch, TwoFingersPanAndPinchWhateverTheirOrder) {
    Touch touch(1.0F);
    touch.update({{3, {100, 100}}}, 0.0);
    touch.update({{3, {100, 100}}, {7, {200, 100}}}, 0.1);
    touch.update({{7, {310, 120}}, {3, {110, 120}}}, 0.2);
    const Gesture gesture = touch.take();
    EXPECT_EQ(gesture.pan, glm::vec2(60, 20));
    EXPECT_FLOAT_EQ(gesture.zoom, 2.0F);
    EXPECT_EQ(gesture.orbit, glm::vec2(0.0F));
}

TEST(Touch, AFingerMoreOrLessMovesNothing) {
    Touch touch(1.0F);
    touch.update({{0, {100, 100}}}, 0.0);
    touch.update({{0, {150, 100}}}, 0.1);
    touch.take();
    touch.update({{0, {150, 100}}, {1, {500, 500}}}, 0.2);
    touch.update({{1, {500, 500}}}, 0.3);
    const Gesture gesture = touch.take();
    EXPECT_EQ(gesture.orbit, glm::vec2(0.0F));
    EXPECT_EQ(gesture.pan, glm::vec2(0.0F));
    EXPECT_EQ(gesture.zoom, 1.0F);
    touch.update({{1, {510, 500}}}, 0.4);
    EXPECT_EQ(touch.take().orbit, glm::vec2(10, 0));
}

// Taps twice and returns whether that is a double tap. `pause`: seconds between the taps.
bool doubleTaps(glm::vec2 first, glm::vec2 second, double pause, double length = 0.1) {
    Touch touch(1.0F);
    double time = 0.0;
    for (const glm::vec2 at : {first, second}) {
        touch.update({{0, at}}, time);
        touch.update({}, time += length);
        time += pause;
    }
    return touch.take().doubleTap;
}

TEST(Touch, TwoQuickTapsInOnePlaceAreADoubleTap) {
    EXPECT_TRUE(doubleTaps({100, 100}, {110, 100}, 0.1));
    EXPECT_FALSE(doubleTaps({100, 100}, {100, 100}, 0.8)) << "slow";
    EXPECT_FALSE(doubleTaps({100, 100}, {300, 100}, 0.1)) << "far apart";
    EXPECT_FALSE(doubleTaps({100, 100}, {100, 100}, 0.1, 0.5)) << "long";
    Touch cancelled(1.0F);
    for (int tap = 0; tap < 2; ++tap) {
        cancelled.update({{0, {100, 100}}}, 0.1 * tap);
        if (tap == 1) cancelled.cancel();
        cancelled.update({}, 0.1 * tap + 0.05);
    }
    EXPECT_FALSE(cancelled.take().doubleTap);
}

Scene boxScene() {
    Scene scene = closedBox(0.0);
    Camera camera;
    camera.worldFromCamera[3] = {0.0, 0.0, 4.0, 1.0};
    scene.cameras.push_back(camera);
    return scene;
}

constexpr glm::ivec2 viewport{800, 600};

glm::dvec3 eyeOf(const OrbitView& view) {
    return view.camera(1.0).worldFromCamera[3];
}

// A point of the world in the space of the camera.
glm::dvec3 seen(const OrbitView& view, const glm::dvec3& world) {
    return glm::inverse(view.camera(1.0).worldFromCamera) * glm::dvec4(world, 1.0);
}

TEST(OrbitView, StartsAsTheScenesCameraAndADoubleTapReturnsThere) {
    const Scene scene = boxScene();
    OrbitView view(scene, {}, 1.5);
    EXPECT_EQ(view.camera(1.5).worldFromCamera, scene.cameras[0].worldFromCamera);
    EXPECT_EQ(view.camera(1.5).verticalFovRad, scene.cameras[0].verticalFovRad);
    Gesture gesture;
    gesture.orbit = {50, 20};
    gesture.pan = {10, 10};
    gesture.zoom = 1.5F;
    view.apply(gesture, viewport);
    EXPECT_NE(view.camera(1.5).worldFromCamera, scene.cameras[0].worldFromCamera);
    Gesture reset;
    reset.doubleTap = true;
    view.apply(reset, viewport);
    EXPECT_EQ(view.camera(1.5).worldFromCamera, scene.cameras[0].worldFromCamera);
}

TEST(OrbitView, FollowsTheScenesCameraUntilAFingerMovesItAndAfterADoubleTap) {
    const Scene scene = boxScene();
    OrbitView view(scene, {}, 1.5);
    Camera camera = scene.cameras[0];
    const auto followed = [&](double z) {
        camera.worldFromCamera[3].z = z;
        view.follow(camera);
        return view.camera(1.0).worldFromCamera == camera.worldFromCamera;
    };
    EXPECT_TRUE(followed(3.0));
    view.apply({}, viewport);  // of a frame without a finger
    EXPECT_TRUE(followed(5.0));
    Gesture zoom;
    zoom.zoom = 2.0F;
    view.apply(zoom, viewport);
    EXPECT_NEAR(eyeOf(view).z, 2.5, 1e-9) << "it turns around a point as far away as it is now";
    EXPECT_FALSE(followed(6.0));
    EXPECT_NEAR(eyeOf(view).z, 2.5, 1e-9);
    Gesture reset;
    reset.doubleTap = true;
    view.apply(reset, viewport);
    EXPECT_EQ(eyeOf(view).z, 6.0);
    EXPECT_TRUE(followed(7.0));
}

TEST(OrbitView, TheSceneFollowsTheFinger) {
    OrbitView view(boxScene(), {}, 1.5);
    Gesture gesture;
    gesture.orbit = {60, 0};
    view.apply(gesture, viewport);
    EXPECT_GT(seen(view, {0, 0, 1}).x, 0.1) << "dragged to the right";
    EXPECT_NEAR(glm::length(eyeOf(view)), 4.0, 1e-9) << "it turns around the box";
    OrbitView down(boxScene(), {}, 1.5);
    gesture.orbit = {0, 60};
    down.apply(gesture, viewport);
    EXPECT_LT(seen(down, {0, 0, 1}).y, -0.1) << "dragged down";
    OrbitView panned(boxScene(), {}, 1.5);
    gesture = {};
    gesture.pan = {60, 30};
    panned.apply(gesture, viewport);
    EXPECT_GT(seen(panned, {0, 0, 0}).x, 0.1);
    EXPECT_LT(seen(panned, {0, 0, 0}).y, -0.05);
    OrbitView zoomed(boxScene(), {}, 1.5);
    gesture = {};
    gesture.zoom = 2.0F;
    zoomed.apply(gesture, viewport);
    EXPECT_NEAR(eyeOf(zoomed).z, 2.0, 1e-9);
}

TEST(OrbitView, NeverTurnsOverAndStaysRigid) {
    OrbitView view(boxScene(), {}, 1.5);
    Gesture gesture;
    gesture.orbit = {37, 91};
    for (int i = 0; i < 1000; ++i)
        view.apply(gesture, viewport);
    const glm::dmat4 m = view.camera(1.0).worldFromCamera;
    EXPECT_GT(m[1].y, 0.0);
    EXPECT_NEAR(glm::determinant(glm::dmat3(m)), 1.0, 1e-9);
    EXPECT_NEAR(glm::length(eyeOf(view)), 4.0, 1e-6);
    gesture = {};
    gesture.zoom = 3.0F;
    for (int i = 0; i < 1000; ++i)
        view.apply(gesture, viewport);
    for (int c = 0; c < 3; ++c)
        EXPECT_TRUE(std::isfinite(eyeOf(view)[c]));
}

}  // namespace
}  // namespace vct::test
