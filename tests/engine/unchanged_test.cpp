// What has not changed since the last frame is not made always.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/error.h"
#include "gl/call_log.h"
#include "lab/debug_view.h"
#include "lab/options.h"
#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/grids.h"
#include "support/moving_scenes.h"
#include "support/renderers.h"

namespace vct::test {
namespace {

Settings unchangedSettings(const std::string& preset) {
    Settings settings = presetSettings(preset);
    settings.grid = 64;
    settings.size = glm::ivec2(48);
    settings.shadowMapSize = 128;
    settings.lightFrames = 1;  // what is received stands still after the first frame
    return settings;
}

// A box that crosses the floor in two seconds.
GltfBuilder slidingBox() {
    GltfBuilder builder = openFloor();
    const int box = addCube(builder, {0.8F, 0.1F, 0.1F}, {{"translation", {-1, 0.5, 0}}});
    builder.animate(box, "translation", {0, 2}, {-1, 0.5F, 0, 1, 0.5F, 0});
    return builder;
}

// The steps of a frame by their debug groups, but for those of every frame.
std::string madeBy(Renderer& renderer, Output mode, const Camera& camera) {
    const gl::CallLog log;
    renderer.render({{mode}, camera});
    std::set<std::string> groups;
    for (const auto& [group, calls] : gl::summarize(log.calls()).byGroup)
        groups.insert(group);
    for (const char* ofEveryFrame : {"", "G-buffer", "cone trace"})
        groups.erase(ofEveryFrame);
    if (groups.empty()) return "nothing";
    std::string made;
    if (groups.count("accumulate") > 0) groups.insert("voxelize");
    for (const char* step : {"shadow map", "shadow map's moments", "voxelize", "inject", "mipmap", "gather"})
        if (groups.count(step) > 0) made += (made.empty() ? "" : ", ") + std::string(step);
    return made;
}

class Unchanged : public testing::TestWithParam<const char*> {
  protected:
    Unchanged()
        : context_(openContext(Backend::egl)),
          scene_(load(slidingBox())),
          light_(chooseLight(scene_)),
          settings_(unchangedSettings(GetParam())),
          renderer_(makeRenderer(context_, scene_, light_, settings_)) {}

    void frame(Output mode = Output::gi, const char* camera = "") {
        renderer_.render({{mode}, cameraFromText(camera, scene_)});
    }
    void pose(double seconds) { renderer_.setPose(poseAt(scene_.animation, seconds)); }

    // What the next frame makes besides G-buffer and picture: all of it, all that light changes, nothing, or
    // steps by name.
    std::string made(Output mode = Output::gi, const char* camera = "") {
        const std::string groups = madeBy(renderer_, mode, cameraFromText(camera, scene_));
        if (groups == everything()) return "everything";
        return groups == "shadow map, inject, mipmap, gather" ? "its light" : groups;
    }
    // What another light makes: packed voxels are made anew as a whole.
    std::string itsLight() const { return packed() ? "everything" : "its light"; }
    bool packed() const { return settings_.voxels == Voxels::packed; }
    std::string everything() const {
        return packed() ? "shadow map, voxelize, mipmap" : "shadow map, voxelize, inject, mipmap, gather";
    }

    Context context_;
    Scene scene_;
    DirectionalLight light_;
    Settings settings_;
    Renderer renderer_;
};
INSTANTIATE_TEST_SUITE_P(Presets, Unchanged, testing::Values("thesis", "mobile"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(Unchanged, AFrameLikeTheLastMakesNothingNorDoesAMovingCamera) {
    EXPECT_EQ(made(), "everything");
    EXPECT_EQ(made(), "nothing");
    EXPECT_EQ(made(Output::gi, "eye=1,2,3,target=0,0,0,fov=40"), "nothing");
    EXPECT_EQ(made(Output::giConeShadow), packed() ? "nothing" : "shadow map's moments");
    EXPECT_EQ(made(Output::giConeShadow), "nothing");
    renderer_.setShadowConeAngle(10.0F);
    EXPECT_EQ(made(Output::giConeShadow), "nothing");
}

TEST_P(Unchanged, AnotherLightOrPoseIsMadeAndTheSameMakesNothing) {
    frame();
    renderer_.setLightDirection(light_.directionToLight);
    EXPECT_EQ(made(), "nothing");
    renderer_.setLightDirection(glm::dvec3(0.1, 1.0, 0.2));
    EXPECT_EQ(made(), itsLight());
    EXPECT_EQ(made(), "nothing");
    renderer_.setLightDirection(light_.directionToLight);
    pose(0.2);
    EXPECT_EQ(made(), "everything");
    // Moved and moved back, between frames.
    pose(0.4);
    renderer_.setLightDirection(glm::dvec3(0.1, 1.0, 0.2));
    pose(0.2);
    EXPECT_EQ(made(), itsLight());
    pose(0.5);
    EXPECT_EQ(made(), "everything");
    pose(0.5);
    EXPECT_EQ(made(), "nothing");
    pose(1.5);
    EXPECT_EQ(made(), "everything");
    // Both at once, in a frame of a mode that needs neither.
    pose(0.5);
    EXPECT_EQ(made(Output::phong), "nothing");
    EXPECT_EQ(made(Output::shadowMap), "shadow map");
    EXPECT_EQ(made(Output::shadowMap), "nothing");
    EXPECT_EQ(made(), everything().substr(std::string("shadow map, ").size()));
    EXPECT_EQ(made(Output::phong), "nothing");
    EXPECT_EQ(made(), "nothing");
    // The soft shadow's levels are those of the map that there is.
    const std::string levels = packed() ? "nothing" : "shadow map's moments";
    EXPECT_EQ(made(Output::giConeShadow), levels);
    renderer_.setLightDirection(glm::dvec3(-0.2, 1.0, 0.1));
    EXPECT_EQ(made(), itsLight());
    EXPECT_EQ(made(Output::giConeShadow), levels);
    EXPECT_EQ(made(Output::giConeShadow), "nothing");
}

// What is open is received like light, beside it; the light parts show the first bounce alone.
TEST_P(Unchanged, LightAndOcclusionAreReceivedEachOnItsOwn) {
    frame();
    const std::string occlusion = packed() ? "nothing" : "gather";
    const std::string light = packed() ? "nothing" : "inject, mipmap, gather";
    EXPECT_EQ(made(Output::ao), occlusion);
    EXPECT_EQ(made(Output::ao), "nothing");
    EXPECT_EQ(made(Output::gi), "nothing");
    pose(0.3);
    EXPECT_NE(made(Output::ao), "nothing");
    EXPECT_EQ(made(Output::gi), light);
    EXPECT_EQ(made(Output::ao), "nothing");
    EXPECT_EQ(made(Output::gi), "nothing");
    lightParts(renderer_, chooseCamera(scene_, ""));
    EXPECT_EQ(made(Output::gi), light);
    EXPECT_EQ(made(Output::ao), "nothing");
    EXPECT_EQ(made(Output::gi), "nothing");
}

TEST_P(Unchanged, AfterAnErrorEverythingIsMade) {
    frame();
    gl::Enable(GL_TEXTURE_3D);  // no such state in ES: the error is found at the frame's end
    EXPECT_THROW(frame(), Error);
    EXPECT_EQ(made(), "everything");
    renderer_.setPose({});  // of too few nodes: found half way
    EXPECT_ANY_THROW(frame());
    pose(0.0);
    EXPECT_EQ(made(), "everything");
    EXPECT_EQ(made(), "nothing");
}

// Voxels that are made anew receive a little more light in each frame, so those pictures are others.
TEST_P(Unchanged, RevoxelizeMakesEverythingInEveryFrameAndTheSamePictures) {
    settings_.revoxelize = true;
    Renderer always = makeRenderer(context_, scene_, light_, settings_);
    const auto expectSamePicture = [&](Output mode, const char* camera, const std::string& what) {
        frame(mode, camera);
        always.render({{mode}, cameraFromText(camera, scene_)});
        if (packed() || !reads(mode).voxels) {
            EXPECT_TRUE(renderer_.radiance().pixels == always.radiance().pixels) << what;
        } else {
            expectSameGrid(gridOf(renderer_), gridOf(always), what);
        }
        EXPECT_EQ(renderer_.activeVoxels(), always.activeVoxels()) << what;
    };
    for (Output mode : allModes()) {
        expectSamePicture(mode, "", outputName(mode));
        expectSamePicture(mode, "", outputName(mode));
        expectSamePicture(mode, "eye=1,2,3,target=0,0,0,fov=40", outputName(mode));
    }
    frame(Output::giConeShadow);
    const Image before = renderer_.radiance();
    for (Renderer* renderer : {&renderer_, &always}) {
        renderer->setPose(poseAt(scene_.animation, 1.2));
        renderer->setLightDirection(glm::dvec3(0.5, 1.0, 0.0));
    }
    expectSamePicture(Output::giConeShadow, "", "moved");
    EXPECT_FALSE(renderer_.radiance().pixels == before.pixels);
    expectSamePicture(Output::giConeShadow, "", "moved before");
    EXPECT_EQ(madeBy(always, Output::gi, chooseCamera(scene_, "")), everything());
}

}  // namespace
}  // namespace vct::test
