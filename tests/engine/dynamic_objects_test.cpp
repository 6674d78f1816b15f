// What frames cost where something moves: voxelization, memory, and room in the lists.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "gl/call_log.h"
#include "support/grids.h"
#include "support/playing_scene.h"
#include "support/voxel_kinds.h"

namespace vct::test {
namespace {

class Partial : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Voxels, Partial, everyVoxelKind(), nameOfPreset);

TEST(DynamicObjects, ManyFramesLeaveNothingBehindAndTakeNoMoreMemory) {
    const Context context = openContext(Backend::egl);
    const Scene scene = load(twoThatMove());
    Settings settings = mobileSettings();
    settings.size = glm::ivec2(24);
    PlayingScene stage(context, scene, settings);
    std::size_t bytes = 0;
    // After once to and fro there is room for every pose, in the memory of received light too.
    for (int frame = 0; frame <= 192; ++frame) {
        const double seconds = std::abs(std::fmod(frame / 24.0, 4.0) - 2.0);
        if (frame > 96 && frame % 32 == 0)
            expectFresh(stage, context, scene, settings, seconds);
        else
            stage.frameAt(seconds);
        if (frame == 96) bytes = bytesOf(stage.renderer().resources());
        if (frame > 96) {
            ASSERT_EQ(bytesOf(stage.renderer().resources()), bytes) << "frame " << frame;
        }
    }
}

// A room with a hundred cubes in it, the first of which moves.
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
    settings.countInvocations = true;
    settings.revoxelize = revoxelize;
    return settings;
}

// Counts of the shaders in frames where that cube moves.
std::vector<std::uint32_t> countsInTheRoom(const Context& context, const Settings& settings, Output output,
                                           int frames = 1) {
    const Scene scene = room();
    PlayingScene stage(context, scene, settings);
    const auto frameAt = [&](double seconds) { stage.frameAt(seconds, output); };
    for (int i = 0; i < 6; ++i)
        frameAt(0.05 * i);
    std::vector<std::uint32_t> counts(VCT_COUNTER_COUNT);
    const gl::Buffer counters("counters", GL_SHADER_STORAGE_BUFFER, counts.size() * sizeof counts[0],
                              counts.data(), GL_DYNAMIC_COPY);
    counters.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_COUNTERS);
    for (int i = 0; i < frames; ++i)
        frameAt(0.3 + 0.05 * i);
    counters.read(counts.data(), counters.bytes());
    return counts;
}

// By the fragments of both passes over the triangles, and the faces that are listed.
TEST(DynamicObjects, OneOfAHundredIsVoxelizedAlone) {
    const Context context = openContext(Backend::egl);
    const std::vector<std::uint32_t> part = countsInTheRoom(context, roomSettings(128, false), Output::ao),
                                     all = countsInTheRoom(context, roomSettings(128, true), Output::ao);
    for (const int visits : {VCT_COUNTER_MARK_FACES, VCT_COUNTER_ACCUMULATE, VCT_COUNTER_LIST_FACES_FACE}) {
        EXPECT_GT(part[visits], 20U) << visits;
        EXPECT_LT(50 * part[visits], all[visits]) << visits;
    }
}

// The faces of 128^3 voxels are four times those of 64^3, and take turns as much more rarely.
TEST(DynamicObjects, ConesOfAFrameKeepToTheBudgetWhateverTheGrid) {
    const Context context = openContext(Backend::egl);
    for (const int grid : {64, 128}) {
        Settings settings = roomSettings(grid, true);
        settings.gather.coneBudget = 2000;
        const std::vector<std::uint32_t> counts = countsInTheRoom(context, settings, Output::gi, 8);
        EXPECT_GT(counts[VCT_COUNTER_CHOOSE_FACES_FACE], 8U * 10000U) << grid;
        EXPECT_GT(counts[VCT_COUNTER_IRRADIANCE_CONE], 8U * 1400U) << grid;
        EXPECT_LT(counts[VCT_COUNTER_IRRADIANCE_CONE], 8U * 2600U) << grid;
    }
}

// Counts arrive through a fence, and are read before the first pass of a later frame.
TEST(DynamicObjects, NoFrameReadsBackBetweenItsPasses) {
    const Context context = openContext(Backend::egl);
    const Scene scene = load(twoThatMove());
    PlayingScene stage(context, scene, mobileSettings());
    for (const double seconds : {0.0, 1.0, 0.0})
        stage.settledAt(seconds);
    int reads = 0;
    for (int frame = 0; frame < 12; ++frame) {
        const gl::CallLog log;
        stage.frameAt(0.02 * frame);
        bool inPasses = false;
        for (const gl::Call& call : log.calls()) {
            const std::string name = call.name;
            inPasses |= name.rfind("Draw", 0) == 0 || name.rfind("Dispatch", 0) == 0;
            if (name != "MapBufferRange" && name != "ReadPixels") continue;
            ++reads;
            EXPECT_FALSE(inPasses) << name << " in frame " << frame;
        }
    }
    EXPECT_GT(reads, 0) << "no counts arrive";
}

// What finds no room in the list is removed too, once it has moved on.
TEST_P(Partial, AnOverflowIsReportedAndLeavesNothingBehind) {
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

// Head room and triangles of its own are for what moves.
TEST(DynamicObjects, AStaticSceneTakesLess) {
    const Context context = openContext(Backend::egl);
    const Scene scene = load(twoThatMove());
    const Scene frozen = frozenAt(scene, 0.0);
    const Settings settings = mobileSettings();
    PlayingScene moving(context, scene, settings), still(context, frozen, settings);
    moving.frameAt(0.0);
    still.frame();
    EXPECT_LT(bytesOf(still.renderer().resources()), bytesOf(moving.renderer().resources()));
    EXPECT_EQ(bytesOf(still.renderer().resources(), "voxels of dynamic objects"), 0U);
    // A pose of nothing changes nothing.
    const Grid grid = gridOf(still.renderer());
    still.renderer().setPose({});
    still.frame();
    expectSameGrid(grid, gridOf(still.renderer()), "still");
}

}  // namespace
}  // namespace vct::test
