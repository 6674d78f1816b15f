// The notes about options that change nothing.
#include <gtest/gtest.h>

#include "cli/program_run.h"
#include "support/errors.h"

namespace vct::test {
namespace {

constexpr const char* tinyOutput = " --size 16x16 --out out ";

TEST(WithoutEffect, EachOptionIsNamedWithTheReason) {
    ProgramRun program;
    program.expectSuccess(
        std::string("render ") + ProgramRun::cornell + tinyOutput +
        "--preset thesis --mode phong --grid 64 --light-frames 3 --cone-angle 2 --light-radius 0.1 "
        "--shadow-map 64 --emission 2 --active-voxels 9999 "
        "--revoxelize --contact-sheet");
    for (const char* option :
         {"--light-frames has no effect: the preset thesis",
          "--cone-angle has no effect: it needs the mode gi-cone",
          "--light-radius has no effect: it needs the mode", "--shadow-map has no effect: the mode phong",
          "--emission has no effect: no surface",
          "--active-voxels has no effect: the modes phong and shadow-map",
          "--grid has no effect: the modes phong", "--revoxelize has no effect: it changes only the times",
          "--contact-sheet has no effect: a sheet needs several modes"})
        expectMentions(program.err, {std::string("note: ") + option});
    // One note for each of the nine options, although there may be two reasons.
    std::size_t notes = 0;
    for (std::size_t at = 0; (at = program.err.find("has no effect", at)) != std::string::npos; ++at)
        ++notes;
    EXPECT_EQ(notes, 9U) << program.err;
}

TEST(WithoutEffect, NothingIsSaidOfOptionsThatHaveOne) {
    ProgramRun program;
    program.expectSuccess(std::string("render ") + ProgramRun::cornell + tinyOutput +
                          "--mode phong,gi-cone-shadow --grid 64 --light-frames 2 --cone-angle 2 "
                          "--shadow-map 64 --active-voxels 99999 --contact-sheet");
    EXPECT_EQ(program.err.find("has no effect"), std::string::npos) << program.err;
    program.expectSuccess("render " VCT_SOURCE_DIR "/assets/moving.glb --mode phong --time 1 --animation 0" +
                          std::string(tinyOutput));
    EXPECT_EQ(program.err.find("has no effect"), std::string::npos) << program.err;
    program.expectSuccess("render " VCT_SOURCE_DIR "/assets/moving.glb --mode phong --animation 0" +
                          std::string(tinyOutput));
    expectMentions(program.err, {"note: --animation has no effect: the scene is shown at rest"});
    program.expectSuccess("render " VCT_SOURCE_DIR
                          "/assets/moving.glb --mode phong --frames 1 --fps 1 --animation 0" +
                          std::string(tinyOutput));
    EXPECT_EQ(program.err.find("has no effect"), std::string::npos) << program.err;
}

TEST(WithoutEffect, OptionsOfInfoAreNamedToo) {
    ProgramRun program;
    program.expectSuccess(std::string("info ") + ProgramRun::cornell +
                          " --print-camera --size 9x9 --grid 64");
    EXPECT_EQ(program.err, "note: --grid has no effect: the camera does not depend on voxels\n");
    program.expectSuccess(std::string("info ") + ProgramRun::cornell + " --light intensity=1 --size 9x9");
    expectMentions(program.err,
                   {"note: --light has no effect", "note: --size has no effect: it needs --print-camera"});
}

TEST(WithoutEffect, OptionsOfLightsDependOnTheScene) {
    ProgramRun program;
    program.expectSuccess(std::string("render ") + ProgramRun::cornell + tinyOutput +
                          "--grid 64 --light-frames 1 --light-radius 0.1 --light intensity=0 --cone-angle 9");
    expectMentions(program.err,
                   {"note: --light-radius has no effect: the scene has no lights besides the sun",
                    "note: --cone-angle has no effect: the scene has no sun"});
}

}  // namespace
}  // namespace vct::test
