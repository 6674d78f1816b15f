// What `vct render` says, and what it leaves.
#include <gtest/gtest.h>

#include "cli/program_run.h"

namespace vct::test {
namespace {

TEST(UsedFolder, PicturesOfAnEarlierRunAreNamedAndKept) {
    ProgramRun program;
    const std::string small =
        std::string("render ") + ProgramRun::cornell + " --size 16x16 --grid 64 --out out ";
    ASSERT_EQ(program.run(small + "--mode phong,ao --contact-sheet --debug-views"), 0) << program.err;
    EXPECT_EQ(program.err.find("not of this run"), std::string::npos) << program.err;
    writeBytes(program.folder.file("out/notes.txt"), "mine");

    ASSERT_EQ(program.run(small + "--mode ao"), 0) << program.err;
    EXPECT_NE(
        program.err.find(
            "note: not of this run, but in out: contact_sheet.png, debug_views, phong.exr, phong.png\n"),
        std::string::npos)
        << program.err;
    EXPECT_NE(readBytes(program.folder.file("out/phong.png")), "");
    EXPECT_EQ(readBytes(program.folder.file("out/notes.txt")), "mine");
}

TEST(Render, EachModeOnceInTheOrderGiven) {
    ProgramRun program;
    ASSERT_EQ(program.run(std::string("render ") + ProgramRun::cornell +
                          " --size 16x16 --grid 64 --out out --mode gi,phong,4,gi"),
              0)
        << program.err;
    const std::size_t gi = program.err.find("mode gi,");
    const std::size_t phong = program.err.find("mode phong,");
    ASSERT_NE(gi, std::string::npos) << program.err;
    EXPECT_NE(program.err.find("mode phong,", gi), std::string::npos) << program.err;
    EXPECT_EQ(program.err.find("mode gi,", phong), std::string::npos) << program.err;
}

TEST(Render, TellsHowLargeVoxelsAreAndWhatIsSmaller) {
    ProgramRun program;
    const std::string options = " --size 16x16 --grid 64 --out out --mode phong";
    ASSERT_EQ(program.run(std::string("render ") + ProgramRun::cornell + options), 0) << program.err;
    EXPECT_NE(program.err.find("\ngrid 64: voxels of 3.39 cm\n"), std::string::npos) << program.err;
    EXPECT_EQ(program.err.find("warning"), std::string::npos) << program.err;
    ASSERT_EQ(program.run("render " VCT_SOURCE_DIR "/assets/thin_wall.glb" + options), 0) << program.err;
    EXPECT_NE(program.err.find("warning: the narrowest 2 % of the surface are parts up to 1 cm thick "
                               "(\"wall\"), less than a voxel"),
              std::string::npos)
        << program.err;
}

TEST(Render, WarnsOnceOfAPictureThatIsCutOffAtWhiteAndTheAdviceCuresIt) {
    ProgramRun program;
    const std::string sun =
        std::string("render ") + ProgramRun::cornell +
        " --size 16x16 --grid 64 --out out --mode phong,shadow-map --light intensity=100000";
    ASSERT_EQ(program.run(sun), 0) << program.err;
    const std::size_t at = program.err.find("warning: phong.png: ");
    ASSERT_NE(at, std::string::npos) << program.err;
    EXPECT_EQ(program.err.find("warning: ", at + 1), std::string::npos) << program.err;
    const std::size_t advice = program.err.find("--exposure ", at);
    ASSERT_NE(advice, std::string::npos) << program.err;
    ASSERT_EQ(program.run(sun + " " + program.err.substr(advice, program.err.find(" (", advice) - advice)), 0)
        << program.err;
    EXPECT_EQ(program.err.find("warning: "), std::string::npos) << program.err;

    ASSERT_EQ(
        program.run("render " VCT_SOURCE_DIR "/assets/moving.glb --size 16x16 --grid 64 --out out --mode "
                    "phong --light intensity=100000 --frames 3 --fps 2"),
        0)
        << program.err;
    const std::size_t first = program.err.find("warning: phong_0000.png: ");
    ASSERT_NE(first, std::string::npos) << program.err;
    EXPECT_EQ(program.err.find("warning: ", first + 1), std::string::npos) << program.err;
}

}  // namespace
}  // namespace vct::test
