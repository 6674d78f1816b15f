// Bad command lines: one line that says what is wrong, a non-zero exit, and nothing written.
#include <gtest/gtest.h>

#include "cli/program_run.h"
#include "support/errors.h"

namespace vct::test {
namespace {

struct BadCommand {
    const char* name;
    std::string arguments;
    std::string says;
};

std::string onCornell(const std::string& command, const std::string& options) {
    return command + " " + ProgramRun::cornell + " " + options;
}

std::string renderCornell(const std::string& options) {
    return onCornell("render", options);
}

std::string renderMoving(const std::string& options) {
    return "render " VCT_SOURCE_DIR "/assets/moving.glb --out out " + options;
}

std::string benchCornell(const std::string& options) {
    return onCornell("bench", options);
}

class CommandLine : public ::testing::TestWithParam<BadCommand> {};

TEST_P(CommandLine, FailsWithOneLineAndWritesNothing) {
    ProgramRun program;
    writeBytes(program.folder.file("file"), "untouched");
    EXPECT_EQ(program.run(GetParam().arguments), 1);
    EXPECT_EQ(lineCount(program.err), 1) << program.err;
    EXPECT_EQ(program.err.rfind("vct: error: ", 0), 0U) << program.err;
    expectMentions(program.err, {GetParam().says});
    EXPECT_EQ(program.out, "");
    EXPECT_EQ(program.folder.list(), std::vector<std::string>{"file"});
    EXPECT_EQ(readBytes(program.folder.file("file")), "untouched");
}

// Not even root can write below a regular file or into /proc.
INSTANTIATE_TEST_SUITE_P(
    Bad, CommandLine,
    ::testing::Values(
        BadCommand{"Mode", renderCornell("--out out --mode sepia"),
                   "--mode: 'sepia' is not a mode; use phong"},
        BadCommand{"ModeAndComma", renderCornell("--out out --mode gi,"), "--mode: '' is not a mode; use"},
        BadCommand{"EmptyOut", renderCornell("--out ''"), "--out: the value is empty; see vct render"},
        BadCommand{"EmptyCamera", renderCornell("--out out --camera ''"), "--camera: the value is empty"},
        BadCommand{"EmptyFolderOfShaders", onCornell("shaders", "--out ''"), "--out: the value is empty"},
        BadCommand{"EmptyScene", "info ''", "scene: the value is empty"},
        BadCommand{"CommandOfALineBreak", "'\n'", "there is no command ' '"},
        BadCommand{"EyeTwice", renderCornell("--out out --camera eye=0,0,1,eye=0,0,2"),
                   "--camera: eye is given more than once; give it once"},
        BadCommand{"ColorTwice", renderCornell("--out out --light color=1,1,1,color=1,0,0"),
                   "--light: color is given more than once; give it once"},
        BadCommand{"ModeTwice", renderCornell("--out out --mode ao --mode gi"),
                   "--mode is given more than once"},
        BadCommand{"Size", renderCornell("--out out --size 400"), "WIDTHxHEIGHT"},
        BadCommand{"ConeAngle", renderCornell("--out out --cone-angle 0"), "the cone angle"},
        BadCommand{"Preset", renderCornell("--out out --preset best"), "thesis"},
        BadCommand{"Backend", renderCornell("--out out --backend direct3d"), "egl, osmesa, zink"},
        BadCommand{"Scene", "render none.glb --out out/deep/er", "none.glb"},
        BadCommand{"OutBelowAFile", renderCornell("--out file/out"), "file/out"},
        BadCommand{"OutInProc", renderCornell("--out /proc/vct"), "/proc/vct"},
        BadCommand{"TimingsBelowAFile", renderCornell("--out out --timings file/t.json"), "file/t.json"},
        BadCommand{"BenchJsonInNoFolder", benchCornell("--json none/b.json"), "none/b.json"},
        BadCommand{
            "NoCommand", "",
            "A command is required; the commands are render, view, bake, bench, compare, info, shaders; see"},
        BadCommand{"UnknownCommand", "rendr a.glb",
                   "there is no command 'rendr' (do you mean render?); the commands are render, view"},
        BadCommand{"CompareWithoutLimits", "compare a.png b.png",
                   "--max-difference and --max-fraction are required"},
        BadCommand{"UnknownOption", renderCornell("--out out --colour red"),
                   "there is no option --colour; see vct render --help"},
        BadCommand{"LongerOption", renderCornell("--output out"),
                   "there is no option --output (do you mean --out?); see"},
        BadCommand{"ShorterOption", renderCornell("--env sky.hdr"), "do you mean --environment?"},
        BadCommand{"SwappedLetters", renderCornell("--smaples 2"), "do you mean --samples?"},
        BadCommand{"OptionOfOtherPrograms", renderCornell("--spp 64"), "do you mean --samples?"},
        BadCommand{"OptionWithoutScene", "render --resolution 64x64", "do you mean --size?"},
        BadCommand{"OnePictureOfSeveral", renderCornell("--out a.png --mode all"),
                   "--out a.png names one picture, and this run writes more (--mode); name a folder"},
        BadCommand{"OtherPicture", renderCornell("--out a.jpg"), "vct writes no .jpg files"},
        BadCommand{"OptionWithoutValue", renderCornell("--size"), "--size needs a value; see vct render"},
        BadCommand{"TwoScenes", renderCornell("other.glb"), "'other.glb' is one argument too many; give one"},
        BadCommand{"OptionInPlaceOfCommand", "--fast",
                   "'--fast' stands where a command or a scene is needed; the commands are render"},
        BadCommand{"InfiniteSky", renderCornell("--out out --sky 1e40"), "radiance must be at most 1e30"},
        BadCommand{"SkyOfNoName", renderCornell("--out out --sky purple"), "or as black, grey, white, blue"},
        BadCommand{"SkyOfFiveDigits", renderCornell("--out out --sky '#12345'"), "write it as #rrggbb"},
        BadCommand{"NanAngle", renderCornell("--out out --cone-angle nan"), "'nan' is not a number"},
        BadCommand{"InfiniteExposure", renderCornell("--out out --exposure 1e39"), "is not a number above 0"},
        BadCommand{"VoxelSizeOfZero", renderCornell("--out out --voxel-size 0"),
                   "'0' is not a number above 0"},
        BadCommand{"NoLightFrames", renderCornell("--out out --light-frames 0"),
                   "must be between 1 and 1000 (--light-frames)\n"},
        BadCommand{"LightBeyondFloat", renderCornell("--out out --light intensity=1e39"),
                   "--light: color times"},
        BadCommand{"UnknownAnimation", renderMoving("--animation walk"), "choose one of 0 (run)"},
        BadCommand{"FramesWithoutFps", renderMoving("--frames 2"), "--frames requires --fps"},
        BadCommand{"FpsAlone", renderMoving("--fps 2"), "add --frames N or --turntable N"},
        BadCommand{"ConvergedAlone", renderMoving("--converged"), "--converged requires --frames"},
        BadCommand{"FramesAndTurntable", renderMoving("--frames 2 --fps 2 --turntable 4"),
                   "--frames excludes --turntable"},
        BadCommand{"FramesAndViews", renderMoving("--frames 2 --fps 2 --debug-views"), "leave out --frames"},
        BadCommand{"InfoScene", "info none.glb", "none.glb"}),
    [](const ::testing::TestParamInfo<BadCommand>& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace vct::test
