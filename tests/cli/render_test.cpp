// The messages and files of `vct render`.
#include <gtest/gtest.h>

#include "cli/program_run.h"
#include "support/errors.h"

namespace vct::test {
namespace {

TEST(UsedFolder, PicturesOfAnEarlierRunAreNamedAndKept) {
    ProgramRun program;
    const std::string small =
        std::string("render ") + ProgramRun::cornell + " --size 16x16 --grid 64 --light-frames 1 --out out ";
    program.expectSuccess(small + "--mode phong,ao --contact-sheet --debug-views");
    EXPECT_EQ(program.err.find("earlier runs"), std::string::npos) << program.err;
    writeBytes(program.folder.file("out/notes.txt"), "mine");

    program.expectSuccess(small + "--mode ao");
    expectMentions(
        program.err,
        {"note: out also has files of earlier runs: contact_sheet.png, debug_views, phong.exr, phong.png\n"});
    EXPECT_NE(readBytes(program.folder.file("out/phong.png")), "");
    EXPECT_EQ(readBytes(program.folder.file("out/notes.txt")), "mine");
}

TEST(Render, PrintsTheSizeOfVoxelsAndWarnsOfSmallerParts) {
    ProgramRun program;
    const std::string options = " --preset thesis --size 16x16 --grid 64 --out out --mode phong";
    program.expectSuccess(std::string("render ") + ProgramRun::cornell + options);
    expectMentions(program.err, {"\ngrid 64: voxels of 3.39 cm\n"});
    EXPECT_EQ(program.err.find("warning"), std::string::npos) << program.err;
    program.expectSuccess("render " VCT_SOURCE_DIR "/assets/thin_wall.glb" + options);
    expectMentions(program.err, {"warning: the narrowest 2 % of the surface are parts up to 1 cm thick "
                                 "(\"wall\"), less than a voxel"});
}

TEST(Render, WarnsOnceOfAnExposureThatIsTooHighAndGivesOneThatIsNot) {
    ProgramRun program;
    const std::string sun =
        std::string("render ") + ProgramRun::cornell +
        " --size 16x16 --grid 64 --out out --mode phong,shadow-map --light intensity=100000";
    program.expectSuccess(sun + " --exposure 1");
    const std::size_t at = program.err.find("warning: phong.png: ");
    ASSERT_NE(at, std::string::npos) << program.err;
    EXPECT_EQ(program.err.find("warning: ", at + 1), std::string::npos) << program.err;
    const std::size_t advice = program.err.find("--exposure ", at);
    ASSERT_NE(advice, std::string::npos) << program.err;
    program.expectSuccess(sun + " " + program.err.substr(advice, program.err.find(" (", advice) - advice));
    EXPECT_EQ(program.err.find("warning: "), std::string::npos) << program.err;
}

// A sun of real lux gives no white picture, and no sequence flickers.
TEST(Render, ChoosesOneExposureForAllPicturesAndSaysHowToRepeatIt) {
    ProgramRun program;
    const std::string sun = "render " VCT_SOURCE_DIR
                            "/assets/moving.glb --size 16x16 --grid 64 --light-frames 2 --out out --light "
                            "intensity=100000 --mode ";
    program.expectSuccess(sun + "phong,gi --frames 2 --fps 1");
    const std::size_t option = program.err.find("--exposure ");
    ASSERT_NE(option, std::string::npos) << program.err;
    EXPECT_EQ(program.err.find("--exposure ", option + 1), std::string::npos) << program.err;
    EXPECT_EQ(program.err.find("warning: "), std::string::npos) << program.err;
    const std::string chosen = readBytes(program.folder.file("out/phong_0001.png"));
    const std::string repeated = program.err.substr(option, program.err.find(" repeats", option) - option);
    program.expectSuccess(sun + "phong --frames 2 --fps 1 " + repeated);
    EXPECT_EQ(readBytes(program.folder.file("out/phong_0001.png")), chosen);
    EXPECT_NE(program.run(sun + "phong --frames 2 --fps 1 --samples 4"), 0);
    EXPECT_NE(program.err.find("--samples works for one moment"), std::string::npos) << program.err;
}

}  // namespace
}  // namespace vct::test
