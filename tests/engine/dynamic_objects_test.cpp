// Frames in which something moves: the voxelization, memory and cones that they take.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/error.h"
#include "lab/shader_counters.h"
#include "support/gl_spy.h"
#include "support/grids.h"
#include "support/playing_scene.h"
#include "support/voxel_kinds.h"

namespace vct::test {
namespace {

class DynamicObjectsOf : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Voxels, DynamicObjectsOf, everyVoxelKind(), nameOfPreset);

TEST(DynamicObjects, ManyFramesLeaveNothingBehindAndTakeNoMoreMemory) {
    const Context context = openContext(Backend::egl);
    const Scene scene = load(twoThatMove());
    Settings settings = mobileSettings();
    settings.size = glm::ivec2(24);
    PlayingScene stage(context, scene, settings);
    std::size_t bytes = 0;
    // After once there and back every buffer has the capacity for every pose.
    for (int frame = 0; frame <= 36; ++frame) {
        const double seconds = std::abs(std::fmod(frame / 6.0, 4.0) - 2.0);
        if (frame > 24 && frame % 6 == 0)
            expectFresh(stage, context, scene, settings, seconds);
        else
            stage.frameAt(seconds);
        if (frame == 24) bytes = bytesOf(stage.renderer().resources());
        if (frame > 24) {
            ASSERT_EQ(bytesOf(stage.renderer().resources()), bytes) << "frame " << frame;
        }
    }
}

// A room with a hundred cubes. The first one moves.
Scene room() {
    GltfBuilder builder = openFloor();
    const std::vector<float> grey{0.7F, 0.7F, 0.7F};
    addCube(builder, grey, {{"translation", {0, 1.5, -2}}, {"scale", {4, 3, 0.05}}});
    addCube(builder, grey, {{"translation", {-2, 1.5, 0}}, {"scale", {0.05, 3, 4}}});
    addCube(builder, grey, {{"translation", {2, 1.5, 0}}, {"scale", {0.05, 3, 4}}});
    for (int i = 0; i < 100; ++i) {
        const float x = -1.6F + 0.36F * static_cast<float>(i % 10),
                    z = -1.6F + 0.36F * static_cast<float>(i / 10);
        const int cube =
            addCube(builder, {0.2F, 0.7F, 0.3F}, {{"translation", {x, 0.06, z}}, {"scale", {0.1, 0.1, 0.1}}});
        if (i == 0) builder.animate(cube, "translation", {0, 1}, {x, 0.06F, z, x + 0.2F, 0.16F, z + 0.1F});
    }
    return load(builder);
}

Settings roomSettings(int grid, bool revoxelize) {
    Settings settings = mobileSettings();
    settings.grid = grid;
    settings.shadowMapSize = 512;
    settings.revoxelize = revoxelize;
    return settings;
}

// Counts of the shaders over frames in which the cube moves: of all variants of a shader together.
class CountsInTheRoom {
  public:
    CountsInTheRoom(const Context& context, const Settings& settings, Output output, int frames = 1) {
        const Scene scene = room();
        const ShaderCounters counters;
        PlayingScene stage(context, scene, settings, counters.programs());
        const auto frameAt = [&](double seconds) { stage.frameAt(seconds, output); };
        for (int i = 0; i < 6; ++i)
            frameAt(0.05 * i);
        counts_ = counters.count([&] {
            for (int i = 0; i < frames; ++i)
                frameAt(0.3 + 0.05 * i);
        });
    }
    double invocations(const std::string& shader) const {
        return sum(shader, [](const StageCount& stage) { return static_cast<double>(stage.invocations); });
    }
    // Iterations of the loops of one depth.
    double iterations(const std::string& shader, int depth) const {
        return sum(shader, [depth](const StageCount& stage) {
            double all = 0.0;
            for (const LoopCount& loop : stage.loops)
                if (loop.depth == depth) all += loop.iterations;
            return all;
        });
    }

  private:
    double sum(const std::string& shader, const std::function<double(const StageCount&)>& value) const {
        double all = 0.0;
        for (const ProgramCount& count : counts_)
            if (count.stage.shader == shader) all += value(count.stage);
        return all;
    }
    std::vector<ProgramCount> counts_;
};

// Counted are the fragments of both passes over the triangles and the layers of voxels of the marked blocks.
TEST(DynamicObjects, OneOfAHundredIsVoxelizedAlone) {
    const Context context = openContext(Backend::egl);
    const CountsInTheRoom part(context, roomSettings(64, false), Output::ao),
        all(context, roomSettings(64, true), Output::ao);
    const auto expectPart = [](double ofPart, double ofAll, const char* what) {
        EXPECT_GT(ofPart, 4.0) << what;
        EXPECT_LT(50.0 * ofPart, ofAll) << what;
    };
    for (const char* shader : {"directional/mark_faces.frag", "directional/accumulate.frag"})
        expectPart(part.invocations(shader), all.invocations(shader), shader);
    const char* const list = "directional/list_faces.comp";
    expectPart(part.iterations(list, 0), all.iterations(list, 0), list);
}

// 128^3 voxels have four times as many faces as 64^3, of which each traces as many fewer rays again.
TEST(DynamicObjects, RaysOfAFrameKeepToTheBudgetWhateverTheGrid) {
    const Context context = openContext(Backend::egl);
    for (const int grid : {64, 128}) {
        Settings settings = roomSettings(grid, true);
        settings.gather.rayBudget = 1 << 18;
        constexpr int frames = 1;
        const CountsInTheRoom counts(context, settings, Output::gi, frames);
        EXPECT_GT(counts.iterations("directional/gather.comp", 0), frames * 10000) << grid;
        // The loop of rays; the other one at this depth, over the invocations of a face, is short.
        const double rays = counts.iterations("directional/trace_moving.comp", 1);
        EXPECT_GT(rays, frames * 120000) << grid;
        EXPECT_LT(rays, frames * 280000) << grid;
    }
}

// Counts arrive through a fence, and a later frame reads them before its first pass.
TEST(DynamicObjects, NoFrameReadsBackBetweenItsPasses) {
    const Context context = openContext(Backend::egl);
    const Scene scene = load(twoThatMove());
    PlayingScene stage(context, scene, mobileSettings());
    for (const double seconds : {0.0, 1.0, 0.0})
        stage.drawTwiceAt(seconds);
    int reads = 0;
    bool isInPasses = false;
    const auto pass = [&](auto...) { isInPasses = true; };
    const auto read = [&](auto...) {
        ++reads;
        EXPECT_FALSE(isInPasses);
    };
    const GlSpy<&gl::DrawArrays> arrays(pass);
    const GlSpy<&gl::DrawElements> elements(pass);
    const GlSpy<&gl::DispatchCompute> dispatches(pass);
    const GlSpy<&gl::DispatchComputeIndirect> indirectDispatches(pass);
    const GlSpy<&gl::MapBufferRange> maps(read);
    const GlSpy<&gl::ReadPixels> pixels(read);
    for (int frame = 0; frame < 12; ++frame) {
        isInPasses = false;
        stage.frameAt(0.02 * frame);
    }
    EXPECT_GT(reads, 0) << "no counts arrive";
}

TEST_P(DynamicObjectsOf, AnOverflowIsReportedAndLeavesNothingBehind) {
    const Context context = openContext(Backend::egl);
    GltfBuilder builder = openFloor();
    const int box = addCube(builder, {0.2F, 0.2F, 0.9F}, {{"translation", {0, 1, 0}}});
    builder.animate(box, "scale", {0, 1}, {0.1F, 0.1F, 0.1F, 1.5F, 1.5F, 1.5F});
    const Scene scene = load(builder);
    Settings settings = smallPreset(GetParam());
    PlayingScene roomy(context, scene, settings);
    roomy.frameAt(0.2);
    settings.activeVoxelLimit = roomy.renderer().activeVoxels()[0];
    PlayingScene stage(context, scene, settings);
    for (int round = 0; round < 2; ++round) {
        stage.frameAt(0.0);
        EXPECT_THROW(
            {
                stage.frameAt(1.0);
                stage.renderer().activeVoxels();
            },
            Error);
        expectFresh(stage, context, scene, settings, 0.1);
    }
}

}  // namespace
}  // namespace vct::test
