#include "scene/light_choice.h"

#include <gtest/gtest.h>

#include "scene/camera.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

TEST(ChooseLight, TakesTheFirstOrADefaultFromAbove) {
    Scene scene;
    const DirectionalLight fallback = chooseLight(scene);
    EXPECT_NEAR(glm::length(fallback.directionToLight), 1.0, 1e-12);
    EXPECT_GT(glm::min(fallback.directionToLight.x,
                       glm::min(fallback.directionToLight.y, fallback.directionToLight.z)),
              0.0);
    EXPECT_NEAR(fallback.intensity, 3.14159265F, 1e-6F);
    // Beside other lights the default gives none.
    scene.punctualLights.emplace_back();
    EXPECT_EQ(chooseLight(scene).color, glm::vec3(0.0F));
    EXPECT_GT(chooseLight(scene).intensity, 0.0F);
    scene.lights.resize(1);
    scene.lights[0].intensity = 5.0F;
    EXPECT_EQ(chooseLight(scene).intensity, 5.0F);
}

// A room of 2 x 2 x 2 m with an emitter and the first `walls` of: floor, ceiling, left, right, back, front.
Scene roomWithAnEmitter(std::size_t walls) {
    Scene scene = closedBox(0.0);
    scene.instances.resize(walls);
    Material emitter = scene.materials[0];
    emitter.emissive = glm::vec3(2.0F);
    scene.materials.push_back(emitter);
    addBox(scene, {0.4, 0.05, 0.4}, {0.3, 0.9, 0.1}, static_cast<int>(scene.materials.size()) - 1);
    return finished(std::move(scene));
}

TEST(ChooseLight, AnEmitterLightsItsRoom) {
    for (const std::size_t walls : {6, 5}) {
        const Scene room = roomWithAnEmitter(walls);
        EXPECT_EQ(chooseLight(room).intensity, 0.0F) << walls;
        EXPECT_EQ(chooseSky(room, chooseLight(room)), glm::vec3(0.0F)) << walls;
    }
}

// A car with its headlights on needs another light.
TEST(ChooseLight, AnEmitterInTheOpenDoesNotReplaceTheSun) {
    const Scene open = roomWithAnEmitter(1);
    EXPECT_GT(chooseLight(open).intensity, 2.0F);
    EXPECT_GT(chooseSky(open, chooseLight(open)).b, 0.1F);
    Scene car = emptyScene();
    addBox(car, {4, 1, 2});
    car.materials[0].doubleSided = true;
    car.materials.push_back(car.materials[0]);
    car.materials[1].emissive = glm::vec3(2.0F);
    addBox(car, {0.05, 0.2, 0.2}, {2.05, 0.1, 0.6}, 1);
    EXPECT_GT(chooseLight(finished(car)).intensity, 3.0F);
}

TEST(ChooseLight, AnEmissiveTextureDoesNotReplaceTheSun) {
    Scene room = roomWithAnEmitter(6);
    room.textures.resize(1);
    room.materials.back().emissiveTexture = 0;
    EXPECT_GT(chooseLight(room).intensity, 3.0F);
    EXPECT_GT(chooseSky(room, chooseLight(room)).b, 0.1F);
}

TEST(ChooseSky, GoesWithTheSun) {
    const Scene open = roomWithAnEmitter(1);
    DirectionalLight sun = defaultLight();
    const glm::vec3 sky = chooseSky(open, sun);
    EXPECT_GT(sky.b, 0.1F);
    sun.intensity *= 1000.0F;
    EXPECT_NEAR(chooseSky(open, sun).b / sky.b, 1000.0F, 0.01F);
    sun.color = glm::vec3(0.5F, 0.25F, 0.1F);
    EXPECT_NEAR(chooseSky(open, sun).b / sky.b, 500.0F, 0.01F);
    sun.color = glm::vec3(0.0F);
    EXPECT_EQ(chooseSky(open, sun), glm::vec3(0.0F)) << "a scene with point lights alone";
    sun = defaultLight();
    sun.intensity = 0.0F;
    EXPECT_EQ(chooseSky(open, sun), glm::vec3(0.0F));
}

Camera cameraAt(const glm::dvec3& eye) {
    return lookAt(eye, {0.1, 0, 0}, 60.0);
}

// A room of 2 x 2 x 2 m that emits nothing.
Scene darkRoom(std::size_t walls) {
    Scene room = roomWithAnEmitter(walls);
    for (Material& material : room.materials)
        material.emissive = glm::vec3(0.0F);
    return room;
}

TEST(ChooseRoomLight, AClosedRoomWithoutALightGetsOneInItsMiddle) {
    for (const glm::dvec3& eye : {glm::dvec3(0.9, 0.3, 0.8), glm::dvec3(-0.8, -0.7, 0.9)}) {
        const std::optional<PunctualLight> lamp = chooseRoomLight(darkRoom(6), cameraAt(eye));
        ASSERT_TRUE(lamp.has_value());
        const glm::dvec3 place(lamp->worldFromLight[3]);
        EXPECT_LT(glm::length(glm::dvec2(place.x, place.z)), 0.4);
        EXPECT_GT(place.y, 0.3);
        EXPECT_LT(place.y, 0.85);
        EXPECT_NEAR(lamp->intensity, pi, 2.0) << "about pi lux in a metre's distance";
    }
    // The camera looks through the back of the front wall, which stops the sun.
    EXPECT_TRUE(chooseRoomLight(darkRoom(6), cameraAt({0, 0, 4})).has_value());
}

TEST(ChooseRoomLight, OtherScenesGetNone) {
    EXPECT_FALSE(chooseRoomLight(darkRoom(5), cameraAt({0, 0, 0.5}))) << "open at the front";
    Scene windowed = darkRoom(5);
    addQuad(windowed, {0.4, -1, 1}, {-1.4, 0, 0}, {0, 2, 0});
    EXPECT_FALSE(chooseRoomLight(finished(windowed), cameraAt({0, 0, -0.5}))) << "with a tall window";
    EXPECT_FALSE(chooseRoomLight(darkRoom(1), cameraAt({0, 0, 0.5}))) << "in the open";
    EXPECT_FALSE(chooseRoomLight(roomWithAnEmitter(6), cameraAt({0, 0, 0.5}))) << "lit by an emitter";
    Scene crate = emptyScene();
    addBox(crate, {2, 2, 2});
    EXPECT_FALSE(chooseRoomLight(finished(crate), cameraAt({0, 0, 4}))) << "seen from outside";
    Scene lit = darkRoom(6);
    lit.punctualLights.emplace_back();
    EXPECT_FALSE(chooseRoomLight(lit, cameraAt({0, 0, 0.5})));
    lit = darkRoom(6);
    lit.lights.emplace_back();
    EXPECT_FALSE(chooseRoomLight(lit, cameraAt({0, 0, 0.5})));
    EXPECT_FALSE(chooseRoomLight(emptyScene(), cameraAt({0, 0, 0.5})));
}

}  // namespace
}  // namespace vct::test
