#include "scene/near_plane.h"

#include <gtest/gtest.h>

#include "scene/camera.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

// A room of 20 m around an eye at the origin, whose picture is a square of 90 degrees.
Scene room() {
    Scene scene = emptyScene();
    addBox(scene, glm::dvec3(20.0));
    return scene;
}

Camera eyeWithNearPlane(double nearest) {
    Camera camera = lookAt({0, 0, 0}, {0, 0, -1}, 90.0);
    camera.nearest = nearest;
    return camera;
}

TEST(NearPlane, IsTheUsualOneIfNothingIsNear) {
    const Scene scene = finished(room());
    const double usual = usualNearPlane(scene.boundsWorld);
    EXPECT_NEAR(usual, 0.02 * std::sqrt(3.0), 1e-12);
    for (const double nearest : {1e-9, 1e-3, 0.9 * usual})
        EXPECT_NEAR(NearPlane(scene).fitted(eyeWithNearPlane(nearest), 1.0).nearest, usual, 1e-12);
    EXPECT_EQ(NearPlane(scene).fitted(eyeWithNearPlane(1.0), 1.0).nearest, 1.0);
}

TEST(NearPlane, CutsNothingOff) {
    Scene scene = room();
    // A large floor right below the eye enters a picture of 90 degrees at the depth of its height.
    addQuad(scene, {-9, -0.01, 9}, {18, 0, 0}, {0, 0, -18});
    const double fitted = NearPlane(finished(scene)).fitted(eyeWithNearPlane(1e-6), 1.0).nearest;
    EXPECT_LE(fitted, 0.01);
    EXPECT_GE(fitted, 0.009);
    // A picture that is less high sees the floor farther away.
    Camera flat = eyeWithNearPlane(1e-6);
    flat.verticalFovRad *= 0.5;
    EXPECT_GT(NearPlane(finished(scene)).fitted(flat, 2.0).nearest, 0.02);
}

TEST(NearPlane, IgnoresSurfacesOutsideThePicture) {
    Scene scene = room();
    addQuad(scene, {-1, -1, 0.001}, {2, 0, 0}, {0, 2, 0});     // behind the eye
    addQuad(scene, {0.1, -1, -0.001}, {2, 0, 0}, {0, 2, 0});   // to the right
    addQuad(scene, {-1, 0.1, -0.001}, {2, 0, 0}, {0, 2, 0});   // above
    addQuad(scene, {-1, -2.1, -0.001}, {2, 0, 0}, {0, 2, 0});  // below
    const Scene done = finished(scene);
    EXPECT_NEAR(NearPlane(done).fitted(eyeWithNearPlane(1e-6), 1.0).nearest, usualNearPlane(done.boundsWorld),
                1e-12);
}

TEST(NearPlane, NeverLiesInFrontOfTheCamerasOwn) {
    Scene scene = room();
    addQuad(scene, {-1, -1, -0.001}, {2, 0, 0}, {0, 2, 0});
    EXPECT_EQ(NearPlane(finished(scene)).fitted(eyeWithNearPlane(0.005), 1.0).nearest, 0.005);
}

TEST(NearPlane, FollowsMovingObjects) {
    Scene scene = room();
    addQuad(scene, {-1, -1, -5}, {2, 0, 0}, {0, 2, 0});
    scene.instances.back().node = 0;
    const Scene done = finished(scene);
    Pose pose{{glm::dmat4(1.0)}, {}};
    EXPECT_NEAR(NearPlane(done).fitted(eyeWithNearPlane(1e-6), 1.0, &pose).nearest,
                usualNearPlane(done.boundsWorld), 1e-12);
    pose.worldFromNode[0][3].z = 4.99;
    EXPECT_NEAR(NearPlane(done).fitted(eyeWithNearPlane(1e-6), 1.0, &pose).nearest, 0.0099, 1e-6);
}

}  // namespace
}  // namespace vct::test
