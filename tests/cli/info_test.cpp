#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "cli/program_run.h"
#include "platform/contexts.h"
#include "support/moving_scenes.h"

namespace vct::test {
namespace {

struct Outcome {
    int exitCode;
    std::string output;
};

// Mesa can be told through the environment to have less than it has; it reads that once in a process.
Outcome info(const std::string& environment, const std::string& arguments) {
    ProgramRun program;
    const int exitCode = program.run("info " + arguments, environment);
    return {exitCode, program.err + program.out};
}

// Whether the output has the text, where tables are not padded.
bool has(const Outcome& outcome, const std::string& text) {
    return std::regex_replace(outcome.output, std::regex(" +"), " ").find(text) != std::string::npos;
}

TEST(Info, SaysWhatTheDriverIsAndThatNothingIsMissing) {
    const Outcome outcome = info("", "");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_TRUE(has(outcome, "OpenGL ES 3.")) << outcome.output;
    EXPECT_FALSE(has(outcome, "MISSING")) << outcome.output;
}

TEST(Info, NamesWhatIsMissingAndExitsWithOne) {
    if (!has(info("", ""), "Mesa")) GTEST_SKIP() << "only Mesa can be told to lack an extension";
    const Outcome outcome = info(
        "MESA_GLES_VERSION_OVERRIDE=3.1 "
        "MESA_EXTENSION_OVERRIDE='-GL_OES_shader_image_atomic -GL_EXT_geometry_shader'",
        "");
    EXPECT_EQ(outcome.exitCode, 1) << outcome.output;
    EXPECT_TRUE(has(outcome, "MISSING GL_OES_shader_image_atomic")) << outcome.output;
    EXPECT_TRUE(has(outcome, "absent GL_EXT_geometry_shader")) << outcome.output;
    EXPECT_TRUE(has(outcome, "no global illumination without")) << outcome.output;
}

TEST(Info, TakesEssl310WithExtensionsWhereTheContextIsEs31) {
    if (!has(info("", ""), "Mesa")) GTEST_SKIP() << "only Mesa can be told to be an older version";
    const Outcome outcome = info("MESA_GLES_VERSION_OVERRIDE=3.1", "");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_TRUE(has(outcome, "310 es with extensions")) << outcome.output;
    EXPECT_TRUE(has(outcome, "KHR_debug messages and groups")) << outcome.output;
}

TEST(Info, PrintsNothingButItsReportOnZink) {
    VCT_SKIP_IF_ABSENT(Backend::zink);
    const Outcome outcome = info("env -u XDG_RUNTIME_DIR", "--backend zink");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_EQ(outcome.output.compare(0, 9, "back end:"), 0) << outcome.output;
    EXPECT_FALSE(has(outcome, "XDG_RUNTIME_DIR")) << outcome.output;
}

const std::string courtyard = VCT_SOURCE_DIR "/assets/courtyard.glb";

TEST(Info, SaysWhatASceneNeedsAndWhatThatAdds) {
    const Outcome outcome = info("", courtyard + " --preset mobile --size 32x32 --grid 64 --times 1");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_TRUE(has(outcome, "85 instances, ")) << outcome.output;
    EXPECT_TRUE(has(outcome, "mode gi-cone-shadow, 32x32 pixels, 64^3 voxels")) << outcome.output;
    EXPECT_TRUE(has(outcome, "\n| G-buffer | ")) << outcome.output;
    // Its target of 8 bytes a pixel, and the coordinates of the panes.
    EXPECT_TRUE(has(outcome, "\n| emission | +0 | +")) << outcome.output;
    EXPECT_TRUE(has(outcome, "\n| glossy materials | does not occur | | | | |\n")) << outcome.output;
}

TEST(Info, CostsOfASceneAreOfTheModeAndGridAskedFor) {
    const Outcome outcome = info("", courtyard + " --preset mobile --size 32x32 --grid auto --mode phong");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_TRUE(has(outcome, "mode phong, 32x32 pixels, 128^3 voxels")) << outcome.output;
    EXPECT_FALSE(has(outcome, "| shadow map |")) << outcome.output;
}

// What moves costs no pass; a moving light no time, as all is made anew in the frames that are timed.
TEST(Info, CostsOfWhatMoves) {
    GltfBuilder builder = openFloor();
    const int box = addCube(builder, {0.8F, 0.3F, 0.1F}, {{"translation", {0, 0.5, 0}}});
    builder.animate(1, "rotation", {0, 1}, {-0.5F, 0, 0, 0.8660254F, -0.258819F, 0, 0, 0.9659258F});
    builder.animate(box, "translation", {0, 1}, {0, 0.5F, 0, 0.5F, 0.5F, 0});
    const TemporaryFolder folder;
    writeBytes(folder.file("sun.glb"), builder.glb());
    for (const char* preset : {"thesis", "mobile"}) {
        const Outcome outcome =
            info("", folder.file("sun.glb") + " --size 32x32 --grid 64 --times 1 --preset " + preset);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
        EXPECT_TRUE(has(outcome, "\n| moving objects | +0 | +")) << outcome.output;
        EXPECT_TRUE(has(outcome, "\n| moving light | +0 | +0 | +0 | +0.0 | – |\n")) << outcome.output;
    }
}

}  // namespace
}  // namespace vct::test
