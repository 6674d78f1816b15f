// Measurements in the app, which an intent starts, and their files.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program_run.h"
#include "image/image.h"
#include "lab/bench_run.h"
#include "stand_in/stand_in.h"
#include "support/errors.h"
#include "support/temporary_folder.h"

namespace vct::test {
namespace {

using nlohmann::json;

// The app with a folder for its files and a command to begin with.
struct Measuring : StandIn {
    explicit Measuring(const std::string& command) {
        StandIn::files = folder.path();
        intentExtra = command;
        start(96, 64);
    }
    // The app ends once `text` is logged.
    void runUntil(const std::string& text) {
        framesUntilLogged(text);
        run();
    }
    TemporaryFolder folder;
};

json readJson(const TemporaryFolder& files, const std::string& name) {
    return json::parse(readBytes(files.file("results/" + name)), nullptr, false);
}

TEST(MeasureInTheApp, WritesWhatTheCommandLineWrites) {
    Measuring android("bench scene=cornell.glb preset=thesis grid=64 size=32x32 shadow-map=64 repeat=1");
    const TemporaryFolder& files = android.folder;
    android.runUntil("measured: ");
    EXPECT_EQ(android.errors(), "");
    EXPECT_EQ(android.misuse, std::vector<std::string>{});
    EXPECT_EQ(android.windowFlags, 0U) << "the screen may go dark again";

    ProgramRun program;
    program.expectSuccess(std::string("render ") + ProgramRun::cornell +
                          " --preset thesis --mode all --grid 64 --size 32x32 --shadow-map 64 --tone-map "
                          "none --exposure 1 --sky 0,0,0"
                          " --out out --timings t.json");
    const json ours = readJson(files, "timings.json");
    ASSERT_FALSE(ours.is_discarded());
    json theirs = program.json("t.json");
    for (const auto& [key, value] : theirs.items())
        EXPECT_TRUE(ours.contains(key)) << key;
    EXPECT_EQ(ours.at("driver").at("backend"), "android");
    EXPECT_EQ(ours.at("self_test").at("passed"), true);
    EXPECT_EQ(ours.at("modes").at("gi").at("present").at("samples").size(), 5U);
    EXPECT_GT(ours.at("modes").at("gi").at("present").at("min"), 0.0);
    theirs.at("settings").erase("preset");
    for (const auto& [key, value] : theirs.at("settings").items())
        EXPECT_EQ(ours.at("settings").at(key), value) << key;
    EXPECT_EQ(ours.at("active_voxels"), theirs.at("active_voxels"));

    // The screenshots equal the pictures of `vct render` to the bit.
    for (const char* mode : {"phong", "shadow-map", "ao", "gi", "gi-cone-shadow"}) {
        const std::string name = std::string(mode) + ".png";
        EXPECT_EQ(readBytes(files.file("results/" + name)), readBytes(program.folder.file("out/" + name)))
            << mode;
    }
    EXPECT_FALSE(readBytes(files.file("results/done")).empty());
    EXPECT_FALSE(std::filesystem::exists(files.file("results/failed")));
}

struct Failure {
    const char* command;
    const char* says;
};
class MeasureFails : public testing::TestWithParam<Failure> {};
INSTANTIATE_TEST_SUITE_P(Commands, MeasureFails,
                         testing::Values(Failure{"bench scene=none.glb", "none.glb"},
                                         Failure{"sing", "the one command is bench"},
                                         Failure{"bench grid=100", "64, 128, 256, 512"},
                                         Failure{"bench nonsense", "unknown 'nonsense'"}),
                         [](const auto& test) { return "Case" + std::to_string(test.index); });

TEST_P(MeasureFails, WithTheReasonInTheFileFailed) {
    Measuring android(GetParam().command);
    const TemporaryFolder& files = android.folder;
    android.framesUntilLogged("measuring failed: ");
    android.frames(2);
    android.run();
    const std::string failed = readBytes(files.file("results/failed"));
    expectMentions(failed, {GetParam().says});
    EXPECT_FALSE(std::filesystem::exists(files.file("results/done")));
    EXPECT_EQ(android.misuse, std::vector<std::string>{});
}

TEST(RecordingInTheApp, WritesTheTimeAndTheDivisorOfEachFrame) {
    Measuring android("show record=1 display=off steps=off grid=64 mode=phong preset=mobile");
    const TemporaryFolder& files = android.folder;
    android.headroom = 0.5F;
    android.runUntil("recorded ");
    EXPECT_EQ(android.errors(), "");
    EXPECT_EQ(android.windowFlags, 0U) << "the screen may go dark again";
    EXPECT_TRUE(std::filesystem::exists(files.file("results/done")));
    std::istringstream rows(readBytes(files.file("results/frames.csv")));
    std::string row;
    std::getline(rows, row);
    EXPECT_EQ(row, "end_ms,frame_ms,work_ms,divisor,headroom");
    double end = 0.0, sum = 0.0;
    int count = 0;
    while (std::getline(rows, row)) {
        double frame = 0.0, work = 0.0, divisor = 0.0, headroom = 0.0;
        ASSERT_EQ(std::sscanf(row.c_str(), "%lf,%lf,%lf,%lf,%lf", &end, &frame, &work, &divisor, &headroom),
                  5)
            << row;
        sum += frame;
        EXPECT_GT(work, 0.0);
        EXPECT_GE(divisor, 1.0);
        EXPECT_NEAR(headroom, 0.5, 1e-6);
        ++count;
    }
    EXPECT_GE(count, 1) << "one frame may take all of the time";
    EXPECT_GE(end, 1000.0);
    EXPECT_NEAR(sum, end, 1.0);
}

TEST(RecordingInTheApp, OfAMissingSceneFailsAtOnce) {
    Measuring android("show record=60 scene=none.glb");
    android.framesUntilLogged("recording failed: there is no scene 'none.glb'");
    android.run();
    EXPECT_EQ(android.windowFlags, 0U);
}

TEST(MeasureInTheApp, QuittingInTheMiddleSaysFailed) {
    Measuring android("bench size=16x16 grid=64");
    const TemporaryFolder& files = android.folder;
    android.framesUntilLogged("bench: 1 of");
    android.frames(4);
    android.run();
    expectMentions(readBytes(files.file("results/failed")), {"ended before"});
    EXPECT_EQ(android.misuse, std::vector<std::string>{});
}

TEST(MeasureInTheApp, ALostWindowAndAPauseOnlyDelayIt) {
    Measuring android("bench size=16x16 grid=64 repeat=1");
    const TemporaryFolder& files = android.folder;
    android.framesUntilLogged("bench: 1 of");
    android.frames(4);
    android.command(APP_CMD_PAUSE);
    android.loseWindow();
    android.window(64, 96);
    android.command(APP_CMD_RESUME);
    android.runUntil("measured: ");
    EXPECT_EQ(android.errors(), "");
    EXPECT_TRUE(std::filesystem::exists(files.file("results/done")));
}

TEST(MeasureInTheApp, AScenePushedIntoTheFilesFolderCanBeMeasured) {
    Measuring android("bench scene=mine.glb size=16x16 grid=64 repeat=1");
    const TemporaryFolder& files = android.folder;
    std::filesystem::copy_file(VCT_SOURCE_DIR "/assets/thin_wall.glb", files.file("my own.glb"));
    std::filesystem::copy_file(VCT_SOURCE_DIR "/assets/thin_wall.glb", files.file("mine.glb"));
    writeBytes(files.file("notes.txt"), "no scene");
    android.runUntil("measured: ");
    EXPECT_EQ(android.errors(), "");
    EXPECT_EQ(readJson(files, "timings.json").at("scene"), "mine.glb");
}

}  // namespace
}  // namespace vct::test
