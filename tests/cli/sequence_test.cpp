// `vct render` of an animated scene: a moment, a sequence, and what does not go together.
#include <gtest/gtest.h>

#include "cli/program_run.h"
#include "support/moving_scenes.h"

namespace vct::test {
namespace {

constexpr const char* moving = VCT_SOURCE_DIR "/assets/moving.glb";

std::string renderOf(const char* scene, const std::string& options, const char* preset = "mobile") {
    return std::string("render ") + scene + " --preset " + preset + " --mode gi --size 48x40 --out out " +
           options;
}

TEST(Sequence, IsNumberedAndItsFramesAreThoseOfTheirTimes) {
    ProgramRun program;
    // The light of the other presets remembers the frames before.
    const char* const options = "--grid 64 --time 0.5 --frames 3 --fps 2 --timings t.json";
    ASSERT_EQ(program.run(renderOf(moving, options, "thesis")), 0) << program.err;
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(program.folder.file("out")))
        names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"gi_0000.exr", "gi_0000.png", "gi_0001.exr", "gi_0001.png",
                                               "gi_0002.exr", "gi_0002.png"}));
    EXPECT_NE(program.err.find("frame 3 of 3, 1.500 s"), std::string::npos) << program.err;

    const nlohmann::json timings = program.json("t.json");
    EXPECT_EQ(timings.at("method").at("frames"), 3);
    for (const char* step : {"voxelize", "trace", "total"})
        EXPECT_EQ(timings.at("modes").at("gi").at("steps").at(step).at("samples").size(), 3U) << step;

    const auto bytes = [&](const std::string& name) { return readBytes(program.folder.file("out/" + name)); };
    ASSERT_EQ(program.run(renderOf(moving, "--grid 64 --time 1.5", "thesis")), 0) << program.err;
    EXPECT_EQ(bytes("gi.png"), bytes("gi_0002.png"));
    EXPECT_NE(bytes("gi.png"), bytes("gi_0000.png"));
    EXPECT_NE(program.err.find("not of this run, but in out: gi_0000.exr"), std::string::npos) << program.err;
}

// Without a time it is as the file puts the nodes, which is said.
TEST(Sequence, AtRestAnAnimatedSceneSaysSo) {
    ProgramRun program;
    ASSERT_EQ(program.run(renderOf(moving, "")), 0) << program.err;
    EXPECT_NE(program.err.find("shown at rest; --time S"), std::string::npos) << program.err;
    ASSERT_EQ(program.run(renderOf(ProgramRun::cornell, "")), 0) << program.err;
    EXPECT_EQ(program.err.find("--time"), std::string::npos) << program.err;
}

TEST(Sequence, WhatDoesNotGoTogetherIsRefusedBeforeAnythingIsMade) {
    struct Wrong {
        const char* scene;
        const char* options;
        const char* part;  // of the message
    };
    const Wrong wrong[] = {
        {ProgramRun::cornell, "--time 1", "has no animation"},
        {ProgramRun::cornell, "--frames 2 --fps 2", "has no animation"},
        {ProgramRun::cornell, "--animation run", "it has no animation"},
        {moving, "--animation walk", "choose one of 0 (run)"},
        {moving, "--frames 2", "--frames requires --fps"},
        {moving, "--fps 2", "--fps requires --frames"},
        {moving, "--frames 0 --fps 2", "not in range 1 to 10000"},
        {moving, "--frames 2 --fps 0", "not a number above 0"},
        {moving, "--frames 2 --fps inf", "--fps: 'inf' is not a number"},
        {moving, "--time -1", "not in range 0"},
        {moving, "--time nan", "--time: 'nan' is not a number"},
        {moving, "--frames 2 --fps 2 --debug-views", "leave out --frames"},
        {moving, "--frames 2 --fps 2 --contact-sheet", "leave out --frames"},
    };
    for (const Wrong& w : wrong) {
        ProgramRun program;
        EXPECT_EQ(program.run(renderOf(w.scene, w.options)), 1) << w.options;
        EXPECT_NE(program.err.find(w.part), std::string::npos) << w.options << ": " << program.err;
        EXPECT_FALSE(std::filesystem::exists(program.folder.file("out"))) << w.options;
    }
}

// The scene's light and camera move; one that the command line gives stands still.
TEST(Sequence, TheLightAndTheCameraMoveUnlessTheCommandLineGivesThem) {
    GltfBuilder builder = openFloor();
    addCube(builder, {0.8F, 0.3F, 0.1F}, {{"translation", {0, 0.5, 0}}});
    GltfBuilder withCamera = builder;
    // About +X: from 60 to 30 degrees down; and to the side.
    builder.animate(1, "rotation", {0, 1}, {-0.5F, 0, 0, 0.8660254F, -0.258819F, 0, 0, 0.9659258F});
    withCamera.animate(2, "translation", {0, 1}, {0, 2.6F, 5.2F, 2, 2.6F, 5.2F});
    ProgramRun program;
    const auto write = [&](const std::string& name, const GltfBuilder& scene) {
        const Bytes file = scene.glb();
        writeBytes(program.folder.file(name), std::string(file.begin(), file.end()));
    };
    write("sun.glb", builder);
    write("camera.glb", withCamera);
    const auto changes = [&](const char* scene, const std::string& options) {
        EXPECT_EQ(program.run(renderOf(scene, options + " --time 0")), 0) << program.err;
        const std::string first = readBytes(program.folder.file("out/gi.png"));
        EXPECT_EQ(program.run(renderOf(scene, options + " --time 1")), 0) << program.err;
        return readBytes(program.folder.file("out/gi.png")) != first;
    };
    EXPECT_TRUE(changes("sun.glb", ""));
    EXPECT_TRUE(changes("sun.glb", "--light intensity=2"));
    EXPECT_FALSE(changes("sun.glb", "--light direction=0,-1,-1"));
    EXPECT_TRUE(changes("camera.glb", ""));
    EXPECT_TRUE(changes("camera.glb", "--camera front"));
    EXPECT_FALSE(changes("camera.glb", "--camera eye=0,2,5,target=0,0,0,fov=50"));
}

// One key is a constant, also where the sequence is longer than it; keys in no order are an error.
TEST(Sequence, OfOneKeyAndOfUnsortedKeys) {
    GltfBuilder one = openFloor();
    const int box = addCube(one, {0.8F, 0.3F, 0.1F}, {{"translation", {0, 0.5, 0}}});
    GltfBuilder unsorted = one;
    one.animate(box, "translation", {1}, {1, 0.5F, 0});
    unsorted.animate(box, "translation", {0, 2, 1}, {0, 0.5F, 0, 1, 0.5F, 0, 0, 0.5F, 0});
    ProgramRun program;
    const auto write = [&](const std::string& name, const GltfBuilder& scene) {
        const Bytes file = scene.glb();
        writeBytes(program.folder.file(name), std::string(file.begin(), file.end()));
    };
    write("one.glb", one);
    write("unsorted.glb", unsorted);
    const auto picture = [&](const char* name) { return readBytes(program.folder.file(name)); };
    ASSERT_EQ(program.run(renderOf("one.glb", "--frames 3 --fps 1")), 0) << program.err;
    EXPECT_EQ(picture("out/gi_0000.png"), picture("out/gi_0001.png"));
    EXPECT_EQ(picture("out/gi_0000.png"), picture("out/gi_0002.png"));
    ASSERT_EQ(program.run(renderOf("one.glb", "")), 0) << program.err;
    EXPECT_NE(picture("out/gi_0000.png"), picture("out/gi.png")) << "at rest it is elsewhere";

    EXPECT_EQ(program.run("render unsorted.glb --out none --time 1"), 1);
    EXPECT_NE(program.err.find("unsorted.glb"), std::string::npos) << program.err;
    EXPECT_NE(program.err.find("has unsorted keys"), std::string::npos) << program.err;
    EXPECT_FALSE(std::filesystem::exists(program.folder.file("none")));
}

}  // namespace
}  // namespace vct::test
