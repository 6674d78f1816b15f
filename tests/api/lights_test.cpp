// Lights of the interface in include/vct/vct.h, against those of a file, and at run time.
#include "api/described_scene.h"
#include "cli/program_run.h"
#include "image/compare.h"
#include "support/errors.h"

namespace vct::test {
namespace {

class Lights : public Embedded {
  protected:
    Lights() {
        point_.position = {-0.4, 0.9, 0.5};
        point_.color = {1, 0.5F, 0.25F};
        point_.intensity = 1.5F;
        point_.range = 3;
        spot_.type = LightDescription::Type::spot;
        spot_.position = {0.9, 1.3, 0.7};
        spot_.direction = {-0.6, -1, -0.4};
        spot_.intensity = 2;
        spot_.innerConeDegrees = 20;
        spot_.outerConeDegrees = 35;
        moon_.type = LightDescription::Type::directional;
        moon_.direction = {0.5, -1, 0.2};
        moon_.intensity = 0.4F;
    }
    Image picture(GlobalIllumination& light) const { return imageOf(afterBounces(light).radiance); }
    void expectAsFresh(GlobalIllumination& light, const std::vector<LightDescription>& lights,
                       const char* what) {
        SceneDescription scene = described_.scene;
        scene.lights = lights;
        scene.maxLights = 3;
        GlobalIllumination fresh(getProcAddress, scene, optionsOf("mobile"));
        const Difference difference = compareImages(picture(light), picture(fresh), 0.04F);
        EXPECT_TRUE(difference.comparable) << what;
        EXPECT_LE(difference.fraction, 0.01) << what << ": largest difference " << difference.largest;
    }
    LightDescription point_, spot_, moon_;
};

TEST_F(Lights, GiveThePictureOfTheProgram) {
    ProgramRun program;
    described_.file.document["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"intensity", 3}},
        {{"type", "point"}, {"color", {1, 0.5, 0.25}}, {"intensity", 1.5}, {"range", 3}},
        {{"type", "spot"},
         {"intensity", 2},
         {"spot", {{"innerConeAngle", glm::radians(20.0)}, {"outerConeAngle", glm::radians(35.0)}}}},
        {{"type", "directional"}, {"intensity", 0.4}}};
    const auto node = [&](int index, const glm::dvec3& place, const glm::dvec3& direction) {
        const glm::dmat4 matrix = glm::inverse(glm::lookAt(place, place + direction, {0.1, 0.2, 1}));
        described_.file.node({{"matrix", Matrix::of(glm::value_ptr(matrix)).columns},
                              {"extensions", {{"KHR_lights_punctual", {{"light", index}}}}}});
    };
    node(0, {0, 0, 0}, {-0.4, -1, -0.5});
    node(1, {-0.4, 0.9, 0.5}, {0, -1, 0});
    node(2, {0.9, 1.3, 0.7}, {-0.6, -1, -0.4});
    node(3, {0, 0, 0}, {0.5, -1, 0.2});
    writeBytes(program.folder.file("scene.glb"), described_.file.glb());
    program.expectSuccess(
        "render scene.glb --out . --grid 64 --size 96x72 --samples 1 --preset mobile"
        " --camera eye=1.5,1.2,2.5,target=0,0.4,0,fov=50 --sky 0.1,0.2,0.3");
    const Image expected = readImage(program.folder.file("gi-cone-shadow.exr"));

    described_.scene.lights = {point_, spot_, moon_};
    described_.scene.bounds.reset();
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    const Pictures pictures = light.render(described_.view(), GlobalIllumination::Light::converged);
    const Difference difference =
        compareImages(imageOf(pictures.radiance, light.radianceUnit()), expected, 0.002F);
    EXPECT_TRUE(difference.comparable) << difference.reason;
    EXPECT_LE(difference.fraction, 0.01) << "largest difference " << difference.largest;
}

TEST_F(Lights, AreAddedChangedAndRemovedWithNumbersThatStay) {
    described_.scene.lights = {point_};
    described_.scene.maxLights = 3;
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    picture(light);
    EXPECT_EQ(light.addLight(spot_), 1U);
    EXPECT_EQ(light.addLight(moon_), 2U);
    expectAsFresh(light, {point_, spot_, moon_}, "added");
    light.removeLight(0);
    spot_.color = {0, 1, 0};
    spot_.radius = 0.05F;
    light.setLight(1, spot_);
    expectAsFresh(light, {spot_, moon_}, "removed and changed");
    EXPECT_EQ(light.addLight(point_), 0U);
    moon_.intensity = 0;
    light.setLight(2, moon_);
    expectAsFresh(light, {point_, spot_}, "added again, and switched off");
}

TEST_F(Lights, ErrorsNameTheLightAndTheRemedy) {
    described_.scene.lights = {point_};
    described_.scene.maxLights = 2;
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    expectMentions(errorOf([&] { light.setLight(1, spot_); }), {"setLight: there is no light 1"});
    light.addLight(spot_);
    expectMentions(errorOf([&] { light.addLight(moon_); }),
                   {"2 lights", "raise SceneDescription::maxLights"});
    light.removeLight(1);
    expectMentions(errorOf([&] { light.removeLight(1); }), {"removeLight: there is no light 1"});
    spot_.innerConeDegrees = 40;
    expectMentions(errorOf([&] { light.setLight(0, spot_); }), {"setLight: give cone angles"});
    const auto expectError = [&](const LightDescription& wrong, const char* part) {
        described_.scene.lights = {point_, wrong};
        expectMentions(
            errorOf([&] { GlobalIllumination(getProcAddress, described_.scene, optionsOf("mobile")); }),
            {"light 1", part});
    };
    LightDescription wrong = spot_;
    wrong.direction = {0, 0, 0};
    wrong.innerConeDegrees = 0;
    expectError(wrong, "no length");
    wrong = point_;
    wrong.intensity = -1;
    expectError(wrong, "intensity");
    wrong = point_;
    wrong.range = 0;
    expectError(wrong, "range above 0");
    described_.scene.lights.assign(65, point_);
    expectMentions(
        errorOf([&] { GlobalIllumination(getProcAddress, described_.scene, optionsOf("mobile")); }),
        {"65 lights", "the limit is 64"});
}

}  // namespace
}  // namespace vct::test
