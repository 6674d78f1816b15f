// Views of scenes without a camera.
#include "scene/framing.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "lab/options.h"
#include "scene/camera.h"
#include "scene/gltf.h"
#include "scene/subject.h"
#include "support/gltf_builder.h"
#include "support/moving_scenes.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

Scene moved(Scene scene, const glm::dmat4& matrix) {
    for (Instance& instance : scene.instances)
        instance.worldFromObject = matrix * instance.worldFromObject;
    return finished(std::move(scene));
}

Scene boxOf(const glm::dvec3& sides) {
    Scene scene = emptyScene();
    addBox(scene, sides);
    return finished(std::move(scene));
}

// A room of 2 x 2 x 2 m with a box on its floor and the first `walls` of: floor, ceiling, left, right, back,
// front.
Scene roomWithABox(std::size_t walls = 6) {
    Scene scene = closedBox(0.0);
    scene.instances.resize(walls);
    addBox(scene, {0.5, 0.6, 0.5}, {0.3, -0.7, -0.4});
    return finished(std::move(scene));
}

bool isInside(const Scene& scene, const Camera& camera) {
    const glm::dvec3 eye(camera.worldFromCamera[3]);
    return glm::all(glm::greaterThan(eye, scene.boundsWorld.min)) &&
           glm::all(glm::lessThan(eye, scene.boundsWorld.max));
}

// The bounds of all vertices in the picture.
Bounds inThePicture(const Scene& scene, const Camera& camera, double aspect) {
    const glm::dmat4 clip = clipFromWorld(camera, scene.boundsWorld, aspect);
    Bounds seen = noBounds;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        for (const Vertex& vertex : mesh.vertices) {
            const glm::dvec4 p =
                clip * instance.worldFromObject * glm::dvec4(mesh.centre + glm::dvec3(vertex.position), 1.0);
            EXPECT_GT(p.w, 0.0);
            seen.include(glm::dvec3(p) / p.w);
        }
    }
    return seen;
}

TEST(FrameScene, FillsThePictureWhateverItsShapeAndSize) {
    for (const glm::dvec3& sides : {glm::dvec3(1, 1, 1), glm::dvec3(0.2, 6, 0.2), glm::dvec3(6, 0.1, 4)}) {
        for (const double size : {1e-3, 1.0, 1e4}) {
            for (const double aspect : {0.3, 1.0, 16.0 / 9.0, 5.0}) {
                for (const double far : {0.0, 1e3}) {
                    const Scene scene =
                        moved(boxOf(sides), glm::translate(glm::dmat4(1.0), glm::dvec3(far * size)) *
                                                glm::scale(glm::dmat4(1.0), glm::dvec3(size)));
                    const std::string what = std::to_string(sides.x) + " x " + std::to_string(sides.y) +
                                             ", times " + std::to_string(size) + ", " +
                                             std::to_string(aspect) + ", " + std::to_string(far);
                    const Bounds seen = inThePicture(scene, frameScene(scene, aspect), aspect);
                    EXPECT_LE(seen.max.x, 1.0) << what;
                    EXPECT_LE(seen.max.y, 1.0) << what;
                    EXPECT_LE(seen.max.z, 1.0) << what;
                    EXPECT_GE(seen.min.x, -1.0) << what;
                    EXPECT_GE(seen.min.y, -1.0) << what;
                    EXPECT_GE(seen.min.z, -1.0) << what;
                    // Apart from a margin it touches two opposite edges.
                    const glm::dvec2 reach = glm::min(glm::dvec2(seen.max), -glm::dvec2(seen.min));
                    EXPECT_GT(std::max(reach.x, reach.y), 0.92) << what;
                }
            }
        }
    }
}

TEST(FrameScene, ItsOptionGivesExactlyTheSameCamera) {
    for (const Scene& scene :
         {boxOf({2, 1, 3}), moved(boxOf({2, 1, 3}), glm::scale(glm::dmat4(1.0), glm::dvec3(1e-3))),
          moved(boxOf({7, 1, 3}), glm::translate(glm::dmat4(1.0), glm::dvec3(1e5))), roomWithABox()}) {
        const Camera framed = frameScene(scene, 1.3);
        const std::string option = cameraOption(framed, scene.boundsWorld);
        const Camera typed = cameraFromText(option, scene, 1.3);
        EXPECT_EQ(typed.worldFromCamera, framed.worldFromCamera) << option;
        EXPECT_EQ(typed.verticalFovRad, framed.verticalFovRad) << option;
        EXPECT_EQ(typed.nearest, framed.nearest) << option;
        EXPECT_LT(option.size(), 90U) << option;
    }
}

TEST(FrameScene, ASheetIsSeenFromTheSideThatItFaces) {
    const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    for (const glm::dvec3& normal : {x, y, z, -x, -y, -z}) {
        const glm::dvec3 u = std::abs(normal.y) > 0.5 ? z : y;
        Scene scene = emptyScene();
        addQuad(scene, {4, 5, 6}, u, glm::cross(normal, u));
        scene = finished(std::move(scene));
        const glm::dvec3 back(frameScene(scene, 1.0).worldFromCamera[2]);
        EXPECT_GT(glm::dot(back, normal), 0.35) << normal.x << " " << normal.y << " " << normal.z;
    }
}

TEST(FrameScene, ADiscThatFacesAnywhereIsSeenFromItsFront) {
    for (int i = 0; i < 64; ++i) {  // a spiral that covers the sphere evenly
        const double y = 1.0 - (2.0 * i + 1.0) / 64.0, azimuth = 2.4 * i;
        const glm::dvec3 normal(std::sqrt(1.0 - y * y) * std::cos(azimuth), y,
                                std::sqrt(1.0 - y * y) * std::sin(azimuth));
        const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(0.31, 0.22, -0.7), normal));
        Scene scene = emptyScene();
        addQuad(scene, {4, 5, 6}, u, glm::cross(normal, u));
        scene = finished(std::move(scene));
        const glm::dvec3 back(frameScene(scene, 1.0).worldFromCamera[2]);
        EXPECT_GT(glm::dot(back, normal), 0.2) << normal.x << " " << normal.y << " " << normal.z;
    }
}

TEST(FrameScene, AnEmptySceneHasAViewToo) {
    EXPECT_TRUE(std::isfinite(frameScene(emptyScene(), 1.0).worldFromCamera[3].z));
}

TEST(FrameScene, AMovingObjectIsSeenInEveryPose) {
    GltfBuilder builder = openFloor();
    addCube(builder, {0.8F, 0.3F, 0.1F}, {{"translation", {0, 0.5, 0}}});
    builder.animate(static_cast<int>(builder.document["nodes"].size()) - 1, "translation", {0, 1},
                    {0, 0.5F, 0, 0, 9, 0});
    Scene scene = load(builder);
    scene.cameras.clear();
    // The floor is the ground. The camera shows the cube at rest and raised, as large as possible.
    EXPECT_TRUE(subjectOf(scene).hasGround);
    const Bounds poses = subjectOf(scene).boundsWorld;
    EXPECT_GT(poses.max.y, 2.5);
    EXPECT_LT(poses.max.x - poses.min.x, 2.0);
    const glm::dmat4 clip = clipFromWorld(frameScene(scene, 1.0), scene.boundsWorld, 1.0);
    double widest = 0.0;
    for (const glm::dvec3& corner : cornersOf(poses)) {
        const glm::dvec4 p = clip * glm::dvec4(corner, 1.0);
        widest = std::max({widest, std::abs(p.x / p.w), std::abs(p.y / p.w)});
    }
    EXPECT_LE(widest, 1.0);
    EXPECT_GT(widest, 0.9);
}

TEST(FrameRoom, AClosedRoomIsSeenFromInsideWhateverTheSidesOfItsWalls) {
    const Scene inwards = roomWithABox();
    EXPECT_TRUE(isInside(inwards, frameScene(inwards, 1.0)));
    Scene doubleSided = roomWithABox();
    doubleSided.materials[0].doubleSided = true;
    EXPECT_TRUE(isInside(doubleSided, frameScene(doubleSided, 1.0)));
    Scene outwards = emptyScene();  // its walls are seen from inside as they have two sides
    outwards.materials[0].doubleSided = true;
    addBox(outwards, {4, 3, 4});
    addBox(outwards, {0.5, 0.6, 0.5}, {0.3, -1.2, -0.4});
    outwards = finished(std::move(outwards));
    EXPECT_TRUE(isInside(outwards, frameScene(outwards, 1.0)));
}

TEST(FrameRoom, LooksAlongTheRoom) {
    const Scene room = moved(roomWithABox(), glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, 4)));
    const Camera camera = frameScene(room, 1.0);
    EXPECT_GT(std::abs(camera.worldFromCamera[2].z), 0.9);
    EXPECT_GT(camera.worldFromCamera[3].z * camera.worldFromCamera[2].z, 2.0) << "the long way is before it";
    EXPECT_LT(std::abs(camera.worldFromCamera[2].y), 0.2);
}

TEST(FrameRoom, AnOpenRoomAndAnObjectAreSeenFromOutside) {
    const Scene open = roomWithABox(5);
    const Camera camera = frameScene(open, 1.0);
    EXPECT_FALSE(isInside(open, camera));
    EXPECT_GT(camera.worldFromCamera[3].z, 1.0) << "through the front";
    Scene crate = boxOf({2, 2, 2});
    crate.materials[0].doubleSided = true;
    EXPECT_FALSE(isInside(crate, frameScene(crate, 1.0)));
    Scene bottle = emptyScene();  // an outside and an inside, and nothing in it
    addBox(bottle, {2, 4, 2});
    addBox(bottle, {-1.9, -3.9, -1.9});
    EXPECT_FALSE(isInside(finished(bottle), frameScene(finished(bottle), 1.0)));
}

// A room of 5 x 2.7 x 4 m of six slabs, with a box in it, and perhaps a window in its back wall.
Scene roomOfSlabs(double thickness, bool window) {
    Scene scene = emptyScene();
    const auto add = [&](const glm::dvec3& from, const glm::dvec3& to) {
        addBox(scene, to - from, 0.5 * (from + to));
    };
    const double t = thickness, x = 2.5, y = 2.7, z = 2.0;
    add({-x - t, -t, -z - t}, {x + t, 0, z + t});
    add({-x - t, y, -z - t}, {x + t, y + t, z + t});
    add({-x - t, 0, -z - t}, {-x, y, z + t});
    add({x, 0, -z - t}, {x + t, y, z + t});
    add({-x, 0, z}, {x, y, z + t});
    if (window) {
        add({-x, 0, -z - t}, {-0.8, y, -z});
        add({0.8, 0, -z - t}, {x, y, -z});
        add({-0.8, 0, -z - t}, {0.8, 0.9, -z});
        add({-0.8, 2.1, -z - t}, {0.8, y, -z});
    } else {
        add({-x, 0, -z - t}, {x, y, -z});
    }
    add({0.6, 0, -0.4}, {1.1, 0.5, 0.1});
    return finished(std::move(scene));
}

PunctualLight lampAt(const glm::dvec3& position) {
    PunctualLight lamp;
    lamp.worldFromLight[3] = glm::dvec4(position, 1.0);
    return lamp;
}

TEST(FrameRoom, ALampBehindAWindowIsSeenFromInside) {
    for (const double thickness : {0.02, 0.2}) {
        Scene room = roomOfSlabs(thickness, true);
        room.lights.push_back(lightFrom({0, 1, 0}));
        EXPECT_FALSE(isInside(room, frameScene(room, 1.0))) << thickness;
        room.lights.clear();
        room.punctualLights.push_back(lampAt({0, 2.2, 0}));
        EXPECT_TRUE(isInside(room, frameScene(room, 1.0))) << thickness;
    }
}

TEST(FrameRoom, ARoomWithAWindowAndWithoutALightIsSeenFromInside) {
    for (const double thickness : {0.02, 0.2}) {
        const Scene room = roomOfSlabs(thickness, true);
        EXPECT_TRUE(isInside(room, frameScene(room, 1.0))) << thickness;
        const Scene box = moved(room, glm::scale(glm::dmat4(1.0), glm::dvec3(0.1)));
        EXPECT_FALSE(isInside(box, frameScene(box, 1.0))) << thickness;
    }
}

TEST(FrameRoom, ALampThatLightsTheOutsideIsSeenFromOutside) {
    Scene room = roomOfSlabs(0.2, true);
    room.punctualLights.push_back(lampAt({0, 4, -8}));
    const Camera camera = frameScene(room, 1.0);
    EXPECT_FALSE(isInside(room, camera));
    EXPECT_LT(camera.worldFromCamera[3].z, -2.0) << "the lit wall is at the back";
    room.punctualLights.clear();
    room.lights.push_back(lightFrom({0, 0, -1}));
    EXPECT_LT(frameScene(room, 1.0).worldFromCamera[3].z, -2.0);
    Scene closed = roomOfSlabs(0.2, false);
    closed.lights.push_back(lightFrom(glm::normalize(glm::dvec3(0, 0.866, 0.5))));
    EXPECT_FALSE(isInside(closed, frameScene(closed, 1.0))) << "the sun does not reach the inside";
}

TEST(FrameRoom, TheEyeIsNeverInAWall) {
    for (const double thickness : {0.02, 0.2, 0.5, 0.7, 1.0}) {
        for (const bool partition : {false, true}) {
            Scene room = roomOfSlabs(thickness, false);
            if (partition) addBox(room, {0.1, 2.7, 3.0}, {0.0, 1.35, -0.5});
            room = finished(std::move(room));
            const glm::dvec3 eye(frameScene(room, 1.0).worldFromCamera[3]);
            EXPECT_TRUE(isInside(room, frameScene(room, 1.0)));
            for (const Instance& instance : room.instances) {
                Bounds box = noBounds;
                const Mesh& mesh = room.meshes[static_cast<std::size_t>(instance.mesh)];
                for (const Vertex& vertex : mesh.vertices)
                    box.include(mesh.centre + glm::dvec3(vertex.position));
                EXPECT_FALSE(glm::all(glm::greaterThan(eye, box.min)) &&
                             glm::all(glm::lessThan(eye, box.max)))
                    << thickness << " " << partition << ": " << eye.x << " " << eye.y << " " << eye.z;
            }
        }
    }
}

// Objects of 1.2 m on a plane of 10 m.
TEST(Framing, AGroundIsNotTheSubject) {
    Scene objects = emptyScene();
    addBox(objects, {0.5, 0.5, 0.5}, {-0.35, 0.25, 0});
    addBox(objects, {0.5, 0.9, 0.5}, {0.35, 0.45, 0});
    objects = finished(std::move(objects));
    Scene scene = objects;
    addQuad(scene, {-5, 0, 5}, {10, 0, 0}, {0, 0, -10});
    scene = finished(std::move(scene));
    const Camera alone = frameScene(objects, 1.0), onGround = frameScene(scene, 1.0);
    EXPECT_LT(glm::distance(glm::dvec3(alone.worldFromCamera[3]), glm::dvec3(onGround.worldFromCamera[3])),
              0.02);
    // A floor that ends where the objects end is a part of them.
    Scene tray = objects;
    addQuad(tray, {-0.8, 0, 0.5}, {1.6, 0, 0}, {0, 0, -1});
    EXPECT_FALSE(subjectOf(finished(std::move(tray))).hasGround);
    EXPECT_TRUE(subjectOf(scene).hasGround);
}

// A rock of 2 m whose lower half is in water of 100 m.
TEST(Framing, WaterIsNotTheSubject) {
    Scene rock = emptyScene();
    addBox(rock, {2, 2, 2});
    rock = finished(std::move(rock));
    Scene scene = rock;
    addQuad(scene, {-50, 0, 50}, {100, 0, 0}, {0, 0, -100});
    scene = finished(std::move(scene));
    EXPECT_TRUE(subjectOf(scene).hasGround);
    EXPECT_LT(glm::distance(glm::dvec3(frameScene(rock, 1.0).worldFromCamera[3]),
                            glm::dvec3(frameScene(scene, 1.0).worldFromCamera[3])),
              0.02);
    // A table top of 3 m on a leg is no ground.
    Scene table = emptyScene();
    addBox(table, {0.2, 0.7, 0.2}, {0, 0.35, 0});
    addQuad(table, {-1.5, 0.7, 1.5}, {3, 0, 0}, {0, 0, -3});
    EXPECT_FALSE(subjectOf(finished(std::move(table))).hasGround);
}

TEST(Framing, ProductsAreSmallOrOnAGround) {
    Scene scene = emptyScene();
    addBox(scene, {1.5, 0.9, 0.5}, {0, 0.45, 0});
    EXPECT_TRUE(isProduct(finished(scene)));
    addBox(scene, {1, 1, 1}, {2, 0.5, 0});
    EXPECT_FALSE(isProduct(finished(scene))) << "3.25 m may be a room";
    addQuad(scene, {-10, 0, 10}, {20, 0, 0}, {0, 0, -20});
    EXPECT_TRUE(isProduct(finished(scene))) << "with a ground it is none";
}

}  // namespace
}  // namespace vct::test
