#include "scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lab/options.h"
#include "support/errors.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

Scene sceneWithBounds(const glm::dvec3& min, const glm::dvec3& max) {
    Scene scene;
    scene.path = "room.glb";
    scene.boundsWorld = {min, max};
    return scene;
}

// Clip coordinates after the division by w.
glm::dvec3 project(const glm::dmat4& clipFromWorld_, const glm::dvec3& world) {
    const glm::dvec4 clip = clipFromWorld_ * glm::dvec4(world, 1.0);
    return glm::dvec3(clip) / clip.w;
}

void expectRigid(const glm::dmat4& m) {
    const glm::dmat3 axes(m);
    const glm::dmat3 product = glm::transpose(axes) * axes;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(product[i][j], i == j ? 1.0 : 0.0, 1e-12);
    }
    EXPECT_NEAR(glm::determinant(axes), 1.0, 1e-12);
}

TEST(LookAt, PutsTheTargetInTheMiddleAndYUp) {
    const Camera camera = lookAt({1, 2, 3}, {1, 2, -5}, 90.0);
    EXPECT_EQ(camera.worldFromCamera, glm::dmat4({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {1, 2, 3, 1}));
    EXPECT_NEAR(camera.verticalFovRad, 1.57079632679, 1e-9);
    const Camera sloped = lookAt({4, 5, 6}, {-1, 0, 2}, 30.0);
    expectRigid(sloped.worldFromCamera);
    EXPECT_GT(sloped.worldFromCamera[1].y, 0.0);
    EXPECT_NEAR(sloped.worldFromCamera[0].y, 0.0, 1e-12);  // the horizon is level
}

TEST(LookAt, StraightUpOrDownTakesZAsUp) {
    for (const double y : {-7.0, 7.0}) {
        const Camera camera = lookAt({0, 0, 0}, {0, y, 0}, 60.0);
        expectRigid(camera.worldFromCamera);
        EXPECT_NEAR(camera.worldFromCamera[1].z, 1.0, 1e-12);
        EXPECT_NEAR(-camera.worldFromCamera[2].y, y / 7.0, 1e-12);
    }
}

TEST(LookAt, RefusesWhatGivesNoView) {
    EXPECT_NE(errorOf([] { lookAt({1, 1, 1}, {1, 1, 1}, 40.0); }), "");
    EXPECT_NE(errorOf([] { lookAt({NAN, 1, 1}, {0, 1, 1}, 40.0); }), "");
    for (const double fov : {0.0, -1.0, 180.0, std::nan("")})
        EXPECT_NE(errorOf([&] { lookAt({1, 1, 1}, {0, 0, 0}, fov); }), "") << fov;
}

TEST(ChooseCamera, ByNameOrIndexOrTheFirst) {
    Scene scene = sceneWithBounds({0, 0, 0}, {1, 1, 1});
    scene.cameras.resize(2);
    scene.cameras[0].name = "front";
    scene.cameras[1].name = "side";
    EXPECT_EQ(chooseCamera(scene, "").name, "front");
    EXPECT_EQ(chooseCamera(scene, "side").name, "side");
    EXPECT_EQ(chooseCamera(scene, "1").name, "side");
    for (const char* wrong : {"2", "back", "99999999999999999999", "-1"}) {
        const std::string message = errorOf([&] { chooseCamera(scene, wrong); });
        expectMentions(message, {"0 \"front\", 1 \"side\""});
    }
}

TEST(ChooseCamera, OneOfAnotherShapeShowsAllThatItFrames) {
    Scene scene = sceneWithBounds({0, 0, 0}, {1, 1, 1});
    scene.cameras.resize(1);
    scene.cameras[0].aspectRatio = 2.0;
    const double tanHalf = std::tan(0.5 * scene.cameras[0].verticalFovRad);
    const Camera square = chooseCamera(scene, "", 1.0), wide = chooseCamera(scene, "0", 3.0);
    EXPECT_NEAR(std::tan(0.5 * square.verticalFovRad), 2.0 * tanHalf, 1e-12);
    EXPECT_EQ(wide.verticalFovRad, scene.cameras[0].verticalFovRad);
    EXPECT_LT(chooseCamera(scene, "", 1e-6).verticalFovRad, pi);
    expectMentions(cameraNote(scene, "", square, 1.0), {"2 times as wide", "above and below"});
    expectMentions(cameraNote(scene, "0", wide, 3.0), {"at its sides"});
    EXPECT_EQ(cameraNote(scene, "", chooseCamera(scene, "", 2.0), 2.0), "");
}

TEST(CameraOption, RepeatsATurnedCamera) {
    const glm::dvec3 up = glm::normalize(glm::dvec3(0.4, 1, 0.1));
    const Camera camera = lookAt({1, 2, 3}, {0.5, 0, -1}, 33.0, up);
    expectRigid(camera.worldFromCamera);
    const std::string option = cameraOption(camera, {glm::dvec3(-1), glm::dvec3(1)});
    const Camera typed = cameraFromText(option, {});
    for (int column = 0; column < 4; ++column)
        EXPECT_NEAR(glm::distance(typed.worldFromCamera[column], camera.worldFromCamera[column]), 0.0, 1e-9)
            << option;
    EXPECT_NE(option.find(",up="), std::string::npos) << option;
    EXPECT_EQ(cameraOption(lookAt({1, 2, 3}, {0.5, 0, -1}, 33.0), {}).find(",up="), std::string::npos);
    expectMentions(errorOf([] { lookAt({0, 0, 1}, {0, 0, 0}, 40.0, glm::dvec3(0, 0, 2)); }), {"up"});
}

TEST(ClipFromWorld, WideViewsDoNotCutTheCornersOff) {
    // The nearest point of the scene lies in the corner of a very wide picture.
    const double tanHalf = std::tan(glm::radians(75.0));
    const glm::dvec3 nearest(0.99 * tanHalf, 0.99 * tanHalf, -1.0);
    const Bounds bounds{nearest + glm::dvec3(0, 0, -50), nearest + glm::dvec3(50, 50, 0)};
    const glm::dmat4 clip = clipFromWorld(lookAt({0, 0, 0}, {0, 0, -1}, 150.0), bounds, 1.0);
    EXPECT_GE(project(clip, nearest).z, -1.0);
}

TEST(ClipFromWorld, IsUsableInsideTheSceneAndLookingAway) {
    const Bounds bounds{glm::dvec3(-5), glm::dvec3(5)};
    const double diagonal = 10.0 * std::sqrt(3.0);
    const glm::dmat4 inside = clipFromWorld(lookAt({0, 0, 0}, {0, 0, -1}, 60.0), bounds, 1.0);
    EXPECT_NEAR(project(inside, {0, 0, -1e-3 * diagonal}).z, -1.0, 1e-9);
    EXPECT_LT(project(inside, {0, 0, -5}).z, 1.0);

    // The scene is a room of a few metres and an object 10 km away.
    Camera camera = lookAt({0, 0, 0}, {0, 0, -5}, 60.0);
    const Bounds wide{glm::dvec3(-5), glm::dvec3(1e4)};
    EXPECT_GE(project(clipFromWorld(camera, wide, 1.0), {0, 0, -0.11}).z, -1.0);
    camera.nearest = 0.01;
    EXPECT_GE(project(clipFromWorld(camera, wide, 1.0), {0, 0, -0.011}).z, -1.0);

    const glm::dmat4 away = clipFromWorld(lookAt({0, 0, 100}, {0, 0, 200}, 60.0), bounds, 1.0);
    EXPECT_TRUE(std::isfinite(glm::determinant(away)));
    EXPECT_LT(project(away, {0, 0, 147.5}).z, project(away, {0, 0, 150}).z);
}

}  // namespace
}  // namespace vct::test
