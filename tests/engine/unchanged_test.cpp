// Frames rebuild only the resources whose inputs have changed.
#include <gtest/gtest.h>

#include <string>

#include "core/error.h"
#include "lab/options.h"
#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/moving_scenes.h"
#include "support/pictures.h"
#include "support/renderers.h"
#include "support/steps.h"
#include "support/voxel_kinds.h"

namespace vct::test {
namespace {

// A box that crosses the floor in two seconds.
GltfBuilder slidingBox() {
    GltfBuilder builder = openFloor();
    const int box = addCube(builder, {0.8F, 0.1F, 0.1F}, {{"translation", {-1, 0.5, 0}}});
    builder.animate(box, "translation", {0, 2}, {-1, 0.5F, 0, 1, 0.5F, 0});
    return builder;
}

class Unchanged : public testing::TestWithParam<const char*> {
  protected:
    Unchanged()
        : context_(openContext(Backend::egl)),
          scene_(load(slidingBox())),
          light_(chooseLight(scene_)),
          settings_(smallPreset(GetParam())),
          renderer_(newRenderer()) {}

    Renderer newRenderer() {
        settings_.lightFrames = 1;  // the irradiance has converged after one frame
        return makeRenderer(context_, scene_, light_, settings_);
    }
    void frame(Output mode = Output::gi, const char* camera = "") {
        renderer_.render({{mode}, cameraFromText(camera, scene_)});
    }
    void pose(double seconds) { renderer_.setPose(poseAt(scene_.animation, seconds)); }
    std::string steps(Output mode = Output::gi, const char* camera = "") {
        return stepsOf(renderer_, [&] { frame(mode, camera); });
    }

    bool isPacked() const { return settings_.voxels == Voxels::packed; }
    std::string all() const {
        return isPacked() ? "shadow_map, voxelize, mipmap" : "shadow_map, voxelize, inject, irradiance";
    }
    // Another light needs other packed voxels, but not other directional ones.
    std::string allForLight() const { return isPacked() ? all() : "shadow_map, inject, irradiance"; }

    Context context_;
    Scene scene_;
    DirectionalLight light_;
    Settings settings_;
    Renderer renderer_;
};
INSTANTIATE_TEST_SUITE_P(Presets, Unchanged, everyVoxelKind(), nameOfPreset);

TEST_P(Unchanged, ARepeatedFrameRunsNoStepNorDoesAMovedCamera) {
    EXPECT_EQ(steps(), all());
    EXPECT_EQ(steps(), "");
    EXPECT_EQ(steps(Output::gi, "eye=1,2,3,target=0,0,0,fov=40"), "");
    EXPECT_EQ(steps(Output::giConeShadow), isPacked() ? "" : "shadow_map");  // its moments
    EXPECT_EQ(steps(Output::giConeShadow), "");
    renderer_.setShadowConeAngle(10.0F);
    EXPECT_EQ(steps(Output::giConeShadow), "");
}

TEST_P(Unchanged, AnotherLightOrPoseRunsTheStepsThatDependOnIt) {
    frame();
    renderer_.setLightDirection(light_.directionToLight);
    EXPECT_EQ(steps(), "");
    renderer_.setLightDirection(glm::dvec3(0.1, 1.0, 0.2));
    EXPECT_EQ(steps(), allForLight());
    EXPECT_EQ(steps(), "");
    pose(0.2);
    EXPECT_EQ(steps(), all());
    pose(0.2);
    EXPECT_EQ(steps().find(isPacked() ? "mipmap" : "inject"), std::string::npos);
    // Two changes before a frame of a mode that needs neither.
    pose(0.5);
    renderer_.setLightDirection(light_.directionToLight);
    frame(Output::phong);
    EXPECT_EQ(steps(Output::shadowMap), "shadow_map");
    EXPECT_EQ(steps(Output::shadowMap), "");
    EXPECT_EQ(steps(), all().substr(std::string("shadow_map, ").size()));
    EXPECT_EQ(steps(Output::phong), "");
    EXPECT_EQ(steps(), "");
}

TEST_P(Unchanged, WhatAnOutputDoesNotReadCanBeFreedAndIsMadeAgain) {
    const auto bytes = [&] {
        std::size_t sum = 0;
        for (const Resource& resource : renderer_.resources())
            sum += resource.bytes;
        return sum;
    };
    frame();
    const Image before = renderer_.radiance();
    frame(Output::ao);
    const std::size_t all = bytes();
    renderer_.dropUnread(Output::gi);
    EXPECT_EQ(steps(), isPacked() ? "" : "irradiance") << "bricks have light in place of visibility";
    EXPECT_EQ(steps(), "");
    frame(Output::phong);
    renderer_.dropUnread(Output::phong);
    EXPECT_LT(bytes(), all / 2);
    EXPECT_EQ(steps(Output::phong), "");
    frame();
    expectSameInHalves(renderer_.radiance(), before);
}

TEST_P(Unchanged, AfterAnErrorEveryStepRuns) {
    frame();
    gl::Enable(GL_TEXTURE_3D);  // ES has no such state: the frame finds the error at its end
    EXPECT_THROW(frame(), Error);
    EXPECT_EQ(steps(), all());
    renderer_.setPose({});  // it has too few nodes, which is found half way
    EXPECT_ANY_THROW(frame());
    pose(0.0);
    EXPECT_EQ(steps(), all());
    EXPECT_EQ(steps(), "");
}

}  // namespace
}  // namespace vct::test
