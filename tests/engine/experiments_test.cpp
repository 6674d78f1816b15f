// The experiments of docs/defects.md: each changes what it says, and nothing else.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "platform/contexts.h"
#include "lab/read_back.h"
#include "scene/camera.h"
#include "support/renderers.h"
#include "support/voxels.h"

namespace vct::test {
namespace {

struct Frames {
    std::vector<Words> voxels;
    Image image;
};

Frames runWith(std::vector<std::string> experiments) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("cornell.glb"));
    Settings settings = smallSettings();
    settings.experiments = std::move(experiments);
    settings.revoxelize = true;
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), settings);
    // Twice: an experiment must not leave anything behind for the next frame.
    renderer.frame(Mode::giConeShadow, chooseCamera(scene, ""));
    renderer.frame(Mode::giConeShadow, chooseCamera(scene, ""));
    Frames run;
    for (int level = 0; level < renderer.voxels()->levels(); ++level)
        run.voxels.push_back(readVoxels(renderer.voxels()->texture(), level));
    run.image = renderer.radiance();
    return run;
}

TEST(Experiments, SecondAtomicChangesNothingButTime) {
    const Frames plain = runWith({});
    const Frames changed = runWith({"second-atomic"});
    EXPECT_EQ(changed.voxels, plain.voxels);
    EXPECT_EQ(changed.image.pixels, plain.image.pixels);
}

TEST(Experiments, RoundedMipsChangeColoursOfCoarserLevelsOnly) {
    const Frames plain = runWith({});
    const Frames changed = runWith({"rounded-mips"});
    EXPECT_EQ(changed.voxels[0], plain.voxels[0]);
    std::int64_t brighter = 0;
    for (std::size_t i = 0; i < plain.voxels[1].size(); ++i) {
        EXPECT_EQ(changed.voxels[1][i] >> 24, plain.voxels[1][i] >> 24);
        for (int c = 0; c < 3; ++c)
            brighter += static_cast<std::int64_t>(shared::voxelColor(changed.voxels[1][i])[c]) -
                        shared::voxelColor(plain.voxels[1][i])[c];
    }
    EXPECT_GT(brighter, 0);  // rounding down loses light
}

TEST(Experiments, TracerExperimentsChangeThePictureAndNotTheVoxels) {
    const Frames plain = runWith({});
    for (const char* name : {"coverage-opacity", "light-share", "long-shadow-steps", "near-start"}) {
        const Frames changed = runWith({name});
        EXPECT_EQ(changed.voxels, plain.voxels) << name;
        EXPECT_NE(changed.image.pixels, plain.image.pixels) << name;
        for (const glm::vec3& pixel : changed.image.pixels)
            for (int c = 0; c < 3; ++c)
                ASSERT_TRUE(std::isfinite(pixel[c])) << name;
    }
}

TEST(Experiments, UnknownNameIsRefused) {
    EXPECT_THROW(runWith({"wishful-thinking"}), Error);
}

}  // namespace
}  // namespace vct::test
