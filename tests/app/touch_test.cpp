// Touches become gestures, and gestures change the view.
#include <gtest/gtest.h>

#include <random>

#include "app/android/activity.h"
#include "app/orbit_view.h"
#include "app/touch.h"
#include "scene/first_surfaces.h"
#include "scene/gltf.h"
#include "stand_in/stand_in.h"
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

// The same box, seen from outside only.
Scene solidBox() {
    Scene scene = boxScene();
    for (Mesh& mesh : scene.meshes)
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            std::swap(mesh.indices[i], mesh.indices[i + 1]);
    return scene;
}

OrbitView viewWithObstacles(const Scene& scene, const Camera& camera) {
    return {scene, camera, 1.5,
            std::make_shared<const TriangleTree>(scene, TriangleTree::Contents::obstacles)};
}

Camera cameraAt(const glm::dvec3& eye) {
    Camera camera;
    camera.worldFromCamera[3] = glm::dvec4(eye, 1.0);
    return camera;
}

// The place of a point of the world in the window, in shares of half its height from its middle.
glm::dvec2 shownAt(const OrbitView& view, const glm::dvec3& world) {
    const Camera camera = view.camera(1.0 * viewport.x / viewport.y);
    const glm::dvec3 p = glm::inverse(camera.worldFromCamera) * glm::dvec4(world, 1.0);
    return glm::dvec2(p) / (-p.z * std::tan(0.5 * camera.verticalFovRad));
}

// A random gesture from one frame to the next.
Gesture randomGesture(std::mt19937& random) {
    std::uniform_real_distribution<float> share(0.0F, 1.0F), way(-120.0F, 120.0F);
    Gesture gesture;
    if (share(random) < 0.2F) gesture.begin = {800.0F * share(random), 600.0F * share(random)};
    if (share(random) < 0.5F)
        gesture.orbit = {way(random), way(random)};
    else
        gesture.pan = {way(random), way(random)};
    if (share(random) < 0.4F) gesture.zoom = std::exp2(2.0F * share(random) - 1.0F);
    return gesture;
}

TEST(OrbitView, TurnsAroundTheEyeInARoomAndAroundTheSceneOutside) {
    Gesture gesture;
    gesture.begin = {400.0F, 300.0F};
    gesture.orbit = {60, 30};
    const Scene room = boxScene();
    OrbitView inside = viewWithObstacles(room, cameraAt({0.2, 0.1, 0.3}));
    const glm::dvec3 ahead(0.2, 0.1, -1.0);
    inside.apply(gesture, viewport);
    EXPECT_EQ(eyeOf(inside), glm::dvec3(0.2, 0.1, 0.3));
    // The point under the finger has moved with it: 60 and 30 of 600 pixels, in shares of half the height.
    const glm::dvec2 after = shownAt(inside, ahead);
    EXPECT_NEAR(after.x, 0.2, 0.02);
    EXPECT_NEAR(after.y, -0.1, 0.02);
    OrbitView outside = viewWithObstacles(solidBox(), cameraAt({0.0, 0.0, 4.0}));
    outside.apply(gesture, viewport);
    EXPECT_GT(glm::distance(eyeOf(outside), glm::dvec3(0.0, 0.0, 4.0)), 0.5);
    EXPECT_NEAR(glm::length(eyeOf(outside)), 4.0, 1e-9);
}

TEST(OrbitView, TwoFingersHoldTheSurfaceThatTheyTouch) {
    OrbitView view = viewWithObstacles(solidBox(), cameraAt({0.0, 0.0, 4.0}));
    Gesture gesture;
    gesture.begin = {400.0F, 300.0F};
    gesture.zoom = 2.0F;
    view.apply(gesture, viewport);
    EXPECT_NEAR(eyeOf(view).z, 2.5, 1e-6) << "half as far from the front side of the box";
    gesture = {};
    gesture.begin = {400.0F, 300.0F};
    gesture.pan = {60, 0};
    view.apply(gesture, viewport);
    EXPECT_NEAR(shownAt(view, {0, 0, 1}).x, 0.2, 1e-6);
}

TEST(OrbitView, PassesNoWall) {
    std::mt19937 random(7);
    const Scene room = boxScene(), solid = solidBox();
    OrbitView inside = viewWithObstacles(room, cameraAt({0.2, 0.1, 0.3}));
    OrbitView outside = viewWithObstacles(solid, cameraAt({0.0, 0.0, 4.0}));
    double reached = 0.0;
    for (int i = 0; i < 3000; ++i) {
        inside.apply(randomGesture(random), viewport);
        outside.apply(randomGesture(random), viewport);
        const glm::dvec3 in = glm::abs(eyeOf(inside)), out = glm::abs(eyeOf(outside));
        ASSERT_LT(std::max({in.x, in.y, in.z}), 1.0) << i;
        ASSERT_GT(std::max({out.x, out.y, out.z}), 1.0) << i;
        reached = std::max({reached, in.x, in.y, in.z});
    }
    EXPECT_GT(reached, 0.98) << "the eye reaches the walls";
}

// The share of all directions in which the first surface shows its back: 1 inside of a wall.
double shareOfBacks(const Scene& scene, const glm::dvec3& eye) {
    int backs = 0, count = 0;
    for (const FirstSurfaces& view : viewsAround(TriangleTree(scene), eye, 4))
        for (const FirstSurface& sample : view.samples) {
            backs += sample.backDistance > 0.0;
            ++count;
        }
    return static_cast<double>(backs) / count;
}

TEST(OrbitView, NoDragEndsInAWallOfTheTown) {
    const Scene town = loadGltf(VCT_SOURCE_DIR "/assets/town.glb");
    const auto obstacles = std::make_shared<const TriangleTree>(town, TriangleTree::Contents::obstacles);
    std::mt19937 random(3);
    for (const Camera& camera : town.cameras) {
        OrbitView view(town, camera, 1.5, obstacles);
        const double first = shareOfBacks(town, eyeOf(view));
        for (int i = 0; i < 200; ++i) {
            view.apply(randomGesture(random), viewport);
            if (i % 50 == 0) {
                EXPECT_LT(shareOfBacks(town, eyeOf(view)), std::max(0.5, first)) << camera.name;
            }
        }
    }
}

// Android reports a mouse above the screen, and wheels, as motion events too.
TEST(Touch, HoverAndWheelAreNoFingers) {
    for (const int action :
         {AMOTION_EVENT_ACTION_DOWN, AMOTION_EVENT_ACTION_UP, AMOTION_EVENT_ACTION_MOVE,
          AMOTION_EVENT_ACTION_CANCEL, AMOTION_EVENT_ACTION_POINTER_DOWN, AMOTION_EVENT_ACTION_POINTER_UP}) {
        const AInputEvent event{AINPUT_EVENT_TYPE_MOTION, action, {}};
        EXPECT_TRUE(app::isTouch(&event)) << action;
    }
    for (const int action : {AMOTION_EVENT_ACTION_HOVER_MOVE, AMOTION_EVENT_ACTION_HOVER_ENTER,
                             AMOTION_EVENT_ACTION_HOVER_EXIT, AMOTION_EVENT_ACTION_SCROLL}) {
        const AInputEvent event{AINPUT_EVENT_TYPE_MOTION, action, {}};
        EXPECT_FALSE(app::isTouch(&event)) << action;
    }
    const AInputEvent key{AINPUT_EVENT_TYPE_KEY, AMOTION_EVENT_ACTION_DOWN, {}};
    EXPECT_FALSE(app::isTouch(&key));
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
