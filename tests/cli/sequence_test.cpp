// `vct render` of an animated scene: one moment, or a sequence.
#include <gtest/gtest.h>

#include <regex>

#include "cli/program_run.h"
#include "image/compare.h"
#include "image/image.h"
#include "support/errors.h"
#include "support/moving_scenes.h"
#include "support/pictures.h"

namespace vct::test {
namespace {

constexpr const char* moving = VCT_SOURCE_DIR "/assets/moving.glb";

std::string renderOf(const char* scene, const std::string& options, const char* preset = "mobile") {
    return std::string("render ") + scene + " --preset " + preset +
           " --mode gi --size 48x40 --light-frames 2 --out out " + options;
}

TEST(Sequence, IsNumberedAndItsFramesAreThoseOfTheirTimes) {
    ProgramRun program;
    // Light of the other presets depends on the frames before.
    const char* const options = "--grid 64 --time 0.5 --frames 3 --fps 2 --exposure 1 --timings t.json";
    program.expectSuccess(renderOf(moving, options, "thesis"));
    EXPECT_EQ(program.folder.list("out"),
              (std::vector<std::string>{"gi_0000.exr", "gi_0000.png", "gi_0001.exr", "gi_0001.png",
                                        "gi_0002.exr", "gi_0002.png"}));
    expectMentions(program.err, {"frame 3 of 3, 1.5 s"});

    const nlohmann::json timings = program.json("t.json");
    EXPECT_EQ(timings.at("method").at("frames"), 3);
    for (const char* step : {"voxelize", "trace", "total"})
        EXPECT_EQ(timings.at("modes").at("gi").at("steps").at(step).at("samples").size(), 3U) << step;

    const auto bytes = [&](const std::string& name) { return readBytes(program.folder.file("out/" + name)); };
    program.expectSuccess(renderOf(moving, "--grid 64 --samples 1 --time 1.5 --exposure 1", "thesis"));
    EXPECT_EQ(bytes("gi.png"), bytes("gi_0002.png"));
    EXPECT_NE(bytes("gi.png"), bytes("gi_0000.png"));
    expectMentions(program.err, {"out also has files of earlier runs: gi_0000.exr"});
}

// Light of a moving lamp or object follows it late, unless each picture has all of its light.
TEST(Sequence, ConvergedFramesAreStillPicturesOfTheirTimes) {
    ProgramRun program;
    const std::string common =
        std::string("render ") + moving + " --mode gi --size 48x40 --exposure 1 --light-frames 15 --out out ";
    const auto farFromStill = [&](const std::string& options) {
        program.expectSuccess(common + "--time 0.5 --frames 2 --fps 1 " + options);
        expectMentions(program.err, {"ffmpeg -y -framerate 1 -i out/gi_%04d.png -frames:v 2 -c:v libx264"});
        return compareImages(readImage(program.folder.file("out/gi_0001.exr")),
                             readImage(program.folder.file("out/gi.exr")), 0.005F)
            .fraction;
    };
    program.expectSuccess(common + "--time 1.5");
    const double converged = farFromStill("--converged"), following = farFromStill("--samples 4");
    EXPECT_LT(converged, 0.1);
    EXPECT_GT(following, 0.15) << "otherwise the test shows nothing";
}

TEST(Sequence, ATurntableMovesTheCameraOnceAround) {
    ProgramRun program;
    GltfBuilder scene = openFloor();
    addCube(scene, {0.8F, 0.3F, 0.1F}, {{"translation", {0, 0.5, 0}}});
    writeBytes(program.folder.file("a b.glb"), scene.glb());
    const std::string options =
        "'a b.glb' --size 48x40 --grid 64 --light-frames 2 --mode phong --exposure 1 ";
    program.expectSuccess(options + "--camera eye=0,2,6,target=0,0,0 --turntable 4");
    EXPECT_EQ(program.folder.list("out/a b").size(), 8U);
    expectMentions(program.err, {"frame 2 of 4, 90 degrees", "-framerate 24 -i 'out/a b/phong_%04d.png'"});
    // A quarter of a turn is from +Z to +X.
    program.expectSuccess(options + "--camera eye=6,2,0,target=0,0,0");
    expectSameInHalves(readImage(program.folder.file("out/a b/phong_0001.exr")),
                       readImage(program.folder.file("out/a b/phong.exr")));
}

TEST(Sequence, ProgressIsInStepsOfLight) {
    ProgramRun program;
    const std::string slow = " --size 16x16 --exposure 1 --samples 1 --light-frames 150";
    program.expectSuccess(std::string("render ") + moving +
                          " --mode gi --out out --time 1 --frames 1 --fps 1 --converged" + slow);
    EXPECT_TRUE(std::regex_search(program.err, std::regex("64\\^3: light: step [0-9]+ of 278: 2 s so far")))
        << program.err;
}

// Without a time the nodes are where the file puts them.
TEST(Sequence, AtRestAnAnimatedSceneSaysSo) {
    ProgramRun program;
    program.expectSuccess(renderOf(moving, ""));
    expectMentions(program.err, {"shown at rest; --time S"});
    program.expectSuccess(renderOf(ProgramRun::cornell, ""));
    EXPECT_EQ(program.err.find("--time"), std::string::npos) << program.err;
}

TEST(Sequence, TheLightAndTheCameraMoveUnlessTheCommandLineGivesThem) {
    GltfBuilder builder = openFloor();
    addCube(builder, {0.8F, 0.3F, 0.1F}, {{"translation", {0, 0.5, 0}}});
    GltfBuilder withCamera = builder;
    // The sun turns about +X from 60 to 30 degrees above the horizon, and the camera moves to the side.
    builder.animate(1, "rotation", {0, 1}, {-0.5F, 0, 0, 0.8660254F, -0.258819F, 0, 0, 0.9659258F});
    withCamera.animate(2, "translation", {0, 1}, {0, 2.6F, 5.2F, 2, 2.6F, 5.2F});
    ProgramRun program;
    writeBytes(program.folder.file("sun.glb"), builder.glb());
    writeBytes(program.folder.file("camera.glb"), withCamera.glb());
    const auto changes = [&](const char* scene, const std::string& options) {
        program.expectSuccess(renderOf(scene, options + " --time 0"));
        const std::string first = readBytes(program.folder.file("out/gi.png"));
        program.expectSuccess(renderOf(scene, options + " --time 1"));
        return readBytes(program.folder.file("out/gi.png")) != first;
    };
    EXPECT_TRUE(changes("sun.glb", ""));
    EXPECT_TRUE(changes("sun.glb", "--light intensity=2"));
    EXPECT_FALSE(changes("sun.glb", "--light direction=0,-1,-1"));
    EXPECT_TRUE(changes("camera.glb", ""));
    EXPECT_TRUE(changes("camera.glb", "--camera front"));
    EXPECT_FALSE(changes("camera.glb", "--camera eye=0,2,5,target=0,0,0,fov=50"));
}

}  // namespace
}  // namespace vct::test
