// Baked light: what a later run shows in its first frame, and what is refused.
#include "engine/baked_light.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "lab/options.h"
#include "scene/light_choice.h"
#include "support/errors.h"
#include "support/face_irradiance.h"
#include "support/moving_scenes.h"
#include "support/pictures.h"
#include "support/renderers.h"
#include "support/scenes.h"
#include "support/steps.h"

namespace vct::test {
namespace {

Scene boxOnFloor() {
    Scene scene = emptyScene();
    addQuad(scene, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0});
    addBox(scene, {1, 1, 1}, {0, 0.5, 0});
    return finished(std::move(scene));
}

class Baked : public testing::Test {
  protected:
    Image picture(Renderer& renderer, const Scene& scene, LightSteps steps) const {
        renderer.render({.outputs = {Output::gi}, .camera = cameraFromText("", scene), .lightSteps = steps});
        return renderer.radiance();
    }
    BakedLight bake(Renderer& renderer, const Scene& scene, const DirectionalLight& sun) const {
        return {lightKey(scene, sun, settings_), renderer.bakeLight()};
    }
    Context context_ = openContext(Backend::egl);
    Settings settings_ = mobileAt(64);
};

TEST_F(Baked, LightIsThatOfTheFirstFrame) {
    const Scene scene = loadGltf(asset("cornell.glb"));
    const DirectionalLight sun = chooseLight(scene);
    Renderer computed = makeRenderer(context_, scene, sun, settings_);
    const Image converged = picture(computed, scene, LightSteps::all);
    Renderer shown = makeRenderer(context_, scene, sun, settings_);
    shown.useBakedLight(bake(computed, scene, sun));
    expectSameInHalves(picture(shown, scene, LightSteps::one), converged);
    EXPECT_EQ(stepsOf(shown, [&] { picture(shown, scene, LightSteps::one); }), "");
}

TEST_F(Baked, LightFollowsTheSun) {
    const Scene scene = boxOnFloor();
    DirectionalLight sun = lightFrom({0.3, 1, 0.2});
    Renderer computed = makeRenderer(context_, scene, sun, settings_);
    picture(computed, scene, LightSteps::all);
    Renderer shown = makeRenderer(context_, scene, sun, settings_);
    shown.useBakedLight(bake(computed, scene, sun));
    picture(shown, scene, LightSteps::one);

    sun.directionToLight = glm::normalize(sun.directionToLight + glm::dvec3(0.6, 0, -0.3));
    Renderer turned = makeRenderer(context_, scene, sun, settings_);
    picture(turned, scene, LightSteps::all);
    shown.setLightDirection(sun.directionToLight);
    picture(shown, scene, LightSteps::all);
    const IrradianceDifference difference = differenceOf(readIrradiance(shown), readIrradiance(turned));
    EXPECT_LE(difference.rms, 0.01 * difference.mean);
    EXPECT_EQ(errorOf([&] { static_cast<void>(shown.bakeLight()); }).substr(0, 37),
              "light can be baked for the scene as i");
}

TEST_F(Baked, LightGoesOnWhereObjectsMove) {
    const Scene scene = load(twoThatMove());
    const DirectionalLight sun = chooseLight(scene);
    Renderer computed = makeRenderer(context_, scene, sun, settings_);
    picture(computed, scene, LightSteps::all);
    const IrradianceByFace converged = readIrradiance(computed);
    Renderer shown = makeRenderer(context_, scene, sun, settings_);
    const BakedLight baked = bake(computed, scene, sun);
    shown.useBakedLight(baked);
    picture(shown, scene, LightSteps::one);
    IrradianceByFace first = readIrradiance(shown);
    EXPECT_LT(baked.faces.size(), first.size()) << "light of moving objects was baked";
    std::erase_if(first, [&](const auto& face) {
        return std::none_of(baked.faces.begin(), baked.faces.end(),
                            [&](const BakedLight::Face& other) { return other.entry == face.first; });
    });
    const IrradianceDifference difference = differenceOf(first, converged);
    EXPECT_LE(difference.rms, 0.1 * difference.mean);
    EXPECT_FALSE(shown.directional()->irradiance()->isConverged());
    picture(shown, scene, LightSteps::all);
    const IrradianceDifference left = differenceOf(readIrradiance(shown), converged);
    EXPECT_LE(left.rms, 0.01 * left.mean);
}

TEST_F(Baked, LightNeedsConvergedLightAndAPresetThatHasFaces) {
    const Scene scene = boxOnFloor();
    Renderer renderer = makeRenderer(context_, scene, noLight(), settings_);
    picture(renderer, scene, LightSteps::one);
    EXPECT_NE(errorOf([&] { static_cast<void>(renderer.bakeLight()); }).find("has not converged"),
              std::string::npos);
    EXPECT_NE(errorOf([&] { renderer.useBakedLight({}); }).find("before the first picture"),
              std::string::npos);
    Renderer thesis = makeRenderer(context_, scene, noLight(), smallSettings());
    EXPECT_NE(errorOf([&] { thesis.useBakedLight({}); }).find("use mobile or quality"), std::string::npos);
    Settings cascades = settings_;
    cascades.cascades = 2;
    Renderer nested = makeRenderer(context_, scene, noLight(), cascades);
    EXPECT_NE(errorOf([&] { nested.useBakedLight({}); }).find("with cascades"), std::string::npos);
}

TEST(BakedLightFile, IsReadBackOrRefusedWithTheReason) {
    const LightKey key{1, 2, 3, 4, 5};
    const BakedLight light{key, {{7, {8, 9}, 10}, {11, {12, 13}, 14}}};
    const std::vector<std::uint8_t> bytes = vct::bytesOf(light);
    EXPECT_EQ(bakedLightOf(bytes, key, "it").faces, light.faces);

    const auto error = [&](const std::vector<std::uint8_t>& changed, const LightKey& here) {
        return errorOf([&] { bakedLightOf(changed, here, "it"); });
    };
    const std::string damaged = "it is truncated or damaged; bake it again";
    for (const std::size_t size : {60U, 80U, unsigned(bytes.size() - 1)})
        EXPECT_EQ(error({bytes.begin(), bytes.begin() + size}, key), damaged);
    for (const std::size_t size : {0U, 7U, 40U})
        EXPECT_EQ(error({bytes.begin(), bytes.begin() + size}, key),
                  "it is no baked light; make one with `vct bake`");
    for (const std::size_t at : {12U, 15U, 16U, 55U, 56U, 70U, unsigned(bytes.size() - 1)}) {
        std::vector<std::uint8_t> flipped = bytes;
        flipped[at] ^= 0x10U;
        EXPECT_EQ(error(flipped, key), damaged) << "byte " << at;
    }
    std::vector<std::uint8_t> longer = bytes, later = bytes;
    longer.push_back(0);
    EXPECT_EQ(error(longer, key), damaged);
    later[8] = 2;
    EXPECT_EQ(error(later, key),
              "it is baked light of version 2, but this program reads version 1; bake it again");
    EXPECT_EQ(error(bytes, {0, 2, 3, 4, 0}),
              "it is baked light of other geometry, settings; bake it again, with the same options");
}

TEST(LightKey, IsThatOfTheSceneItsLightAndTheSettings) {
    const Scene scene = boxOnFloor();
    const DirectionalLight sun = lightFrom({0.3, 1, 0.2});
    const Settings settings = mobileAt(64);
    const LightKey key = lightKey(scene, sun, settings);
    const auto differing = [&](const auto& change) {
        Scene otherScene = scene;
        DirectionalLight otherSun = sun;
        Settings other = settings;
        change(otherScene, otherSun, other);
        return errorOf([&] {
            bakedLightOf(vct::bytesOf(BakedLight{key, {}}), lightKey(otherScene, otherSun, other), "it");
        });
    };
    const auto expect = [&](const char* part, const auto& change) {
        EXPECT_EQ(differing(change), std::string("it is baked light of other ") + part +
                                         "; bake it again, with the same options");
    };
    expect("geometry", [](Scene& s, auto&, auto&) { s.instances[1].worldFromObject[3].x += 0.01; });
    expect("geometry", [](Scene& s, auto&, auto&) { s.meshes[1].vertices[2].position.y += 0.01F; });
    expect("geometry",
           [](Scene& s, auto&, auto&) { std::swap(s.meshes[1].indices[0], s.meshes[1].indices[1]); });
    expect("materials", [](Scene& s, auto&, auto&) { s.materials[0].baseColor.g = 0.7F; });
    expect("materials", [](Scene& s, auto&, auto&) { s.materials[0].emissive.r = 0.1F; });
    expect("materials", [](Scene& s, auto&, auto&) { s.textures.emplace_back(); });
    expect("lights", [](auto&, DirectionalLight& light, auto&) { light.intensity *= 1.01F; });
    expect("lights", [](auto&, DirectionalLight& light, auto&) { light.directionToLight = {0, 1, 0}; });
    expect("lights", [](Scene& s, auto&, auto&) { s.punctualLights.emplace_back(); });
    expect("sky", [](auto&, auto&, Settings& s) { s.skyRadiance.b = 0.1F; });
    expect("settings", [](auto&, auto&, Settings& s) { s.grid = 128; });
    expect("settings", [](auto&, auto&, Settings& s) { s.gather.directions *= 2; });
    // The size of the picture has no part in it, nor has the rounding of another compiler.
    EXPECT_EQ(differing([](Scene& s, DirectionalLight& light, Settings& other) {
                  other.size = {640, 480};
                  light.directionToLight *= 1.0 + 1e-15;
                  s.instances[1].worldFromObject[3].x += 1e-16;
              }),
              "");
}

}  // namespace
}  // namespace vct::test
