// Skins and morph targets on the GPU.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/grids.h"
#include "support/playing_scene.h"
#include "support/voxel_kinds.h"

namespace vct::test {
namespace {

class Deforming : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Voxels, Deforming, everyVoxelKind(), nameOfPreset);

TEST_P(Deforming, EveryFrameIsThatOfAFreshRendererOfItsPose) {
    const Context context = openContext(Backend::egl);
    const Scene scene = load(twoThatDeform());
    ASSERT_EQ(std::count_if(scene.instances.begin(), scene.instances.end(),
                            [](const Instance& instance) { return instance.deforms; }),
              2);
    const Settings settings = smallPreset(GetParam());
    for (const Output mode : {Output::gi, Output::ao}) {
        PlayingScene stage(context, scene, settings);
        for (const double seconds : {0.0, 0.35, 1.0, 1.7, 2.0, 0.35}) {
            stage.settledAt(seconds, mode);
            PlayingScene fresh(context, scene, settings);
            fresh.settledAt(seconds, mode);
            expectSameGrid(gridOf(stage.renderer()), gridOf(fresh.renderer()), std::to_string(seconds));
        }
        const Grid before = gridOf(stage.renderer());
        stage.frameAt(1.7, mode);
        EXPECT_FALSE(gridOf(stage.renderer()).lists == before.lists) << "nothing changes its form";
    }
}

// The GPU computes in float and the CPU in double, so an edge may fall on another pixel.
TEST_P(Deforming, EqualsTheDeformationOfTheCpu) {
    const Context context = openContext(Backend::egl);
    const Scene scene = load(twoThatDeform());
    Settings settings = smallPreset(GetParam());
    settings.size = glm::ivec2(128);
    for (const double seconds : {0.0, 0.6, 1.3, 2.0}) {
        PlayingScene stage(context, scene, settings);
        stage.frameAt(seconds, Output::phong);
        const Scene frozen = frozenAt(scene, seconds);
        PlayingScene expected(context, frozen, settings);
        expected.frame(Output::phong);
        PlayingScene rest(context, scene, settings);
        rest.frame(Output::phong);
        const auto differing = [&](Renderer& a, Renderer& b) {
            const Image x = a.radiance(), y = b.radiance();
            int count = 0;
            for (std::size_t i = 0; i < x.pixels.size(); ++i)
                count += glm::length(x.pixels[i] - y.pixels[i]) > 0.02F ? 1 : 0;
            return count;
        };
        EXPECT_LE(differing(stage.renderer(), expected.renderer()), 16) << seconds << " of 16384 pixels";
        if (seconds > 0.0) {
            EXPECT_GT(differing(stage.renderer(), rest.renderer()), 400) << seconds;
        }
    }
}

}  // namespace
}  // namespace vct::test
