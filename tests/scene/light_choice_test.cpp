#include "scene/light_choice.h"

#include <gtest/gtest.h>

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
        EXPECT_EQ(chooseSky(room), glm::vec3(0.0F)) << walls;
    }
}

// A car with its headlights on needs another light.
TEST(ChooseLight, AnEmitterInTheOpenDoesNotReplaceTheSun) {
    const Scene open = roomWithAnEmitter(1);
    EXPECT_GT(chooseLight(open).intensity, 3.0F);
    EXPECT_GT(chooseSky(open).b, 0.1F);
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
    EXPECT_GT(chooseSky(room).b, 0.1F);
}

}  // namespace
}  // namespace vct::test
