// What `vct render` says, and what it leaves.
#include <gtest/gtest.h>

#include "cli/program_run.h"

namespace vct::test {
namespace {

TEST(UsedFolder, PicturesOfAnEarlierRunAreNamedAndKept) {
    ProgramRun program;
    const std::string small =
        std::string("render ") + ProgramRun::cornell + " --size 16x16 --grid 64 --out out ";
    ASSERT_EQ(program.run(small + "--mode phong,ao --contact-sheet --stages"), 0) << program.err;
    EXPECT_EQ(program.err.find("not of this run"), std::string::npos) << program.err;
    writeBytes(program.folder.file("out/notes.txt"), "mine");

    ASSERT_EQ(program.run(small + "--mode ao"), 0) << program.err;
    EXPECT_NE(program.err.find(
                  "note: not of this run, but in out: contact_sheet.png, phong.exr, phong.png, stages\n"),
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

}  // namespace
}  // namespace vct::test
