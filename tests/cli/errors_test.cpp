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

// Paths below a regular file and in /proc cannot be written by root either.
INSTANTIATE_TEST_SUITE_P(
    Bad, CommandLine,
    ::testing::Values(
        BadCommand{"Mode", renderCornell("--out out --mode sepia"),
                   "--mode: 'sepia' is not a mode; use phong"},
        BadCommand{"Grid", renderCornell("--out out --grid 100"), "100 not in {64,128,256,512,auto}"},
        BadCommand{"Size", renderCornell("--out out --size 400"), "WIDTHxHEIGHT"},
        BadCommand{"ConeAngle", renderCornell("--out out --cone-angle 0"), "the cone angle"},
        BadCommand{"Shadow", renderCornell("--out out --shadow hard"),
                   "--shadow: 'hard' does not exist; use cone or soft-map"},
        BadCommand{"Preset", renderCornell("--out out --preset best"), "thesis"},
        BadCommand{"Backend", renderCornell("--out out --backend direct3d"), "egl, osmesa, zink"},
        BadCommand{"Scene", "render none.glb --out out/deep/er", "none.glb"},
        BadCommand{"OutBelowAFile", renderCornell("--out file/out"), "file/out"},
        BadCommand{"OutIsAFile", renderCornell("--out file"), "not a folder"},
        BadCommand{"OutInProc", renderCornell("--out /proc/vct"), "/proc/vct"},
        BadCommand{"OutIsProc", renderCornell("--out /proc"), "/proc"},
        BadCommand{"TimingsBelowAFile", renderCornell("--out out --timings file/t.json"), "file/t.json"},
        BadCommand{"TimingsInNoFolder", renderCornell("--out out --timings none/t.json"), "none/t.json"},
        BadCommand{"BenchScene", "bench none.glb --out out", "none.glb: there is no such file"},
        BadCommand{"BenchBackend", benchCornell("--backend direct3d"), "egl, osmesa, zink"},
        BadCommand{"BenchPreset", benchCornell("--preset thesis,best"), "mobile"},
        BadCommand{"GridInWords", renderCornell("--out out --grid fine"), "fine not in {64,128"},
        BadCommand{"BenchOutBelowAFile", benchCornell("--out file/out"), "file/out"},
        BadCommand{"BenchJsonInNoFolder", benchCornell("--json none/b.json"), "none/b.json"},
        BadCommand{"NoCommand", "", "A command is required; see vct --help"},
        BadCommand{"UnknownCommand", "bogus a.glb", "not expected: a.glb bogus; see vct --help"},
        BadCommand{"UnknownOption", renderCornell("--out out --colour red"),
                   "not expected: red --colour; see vct render --help"},
        BadCommand{"OneArgumentTooMany", renderCornell("other.glb last.glb --out out"),
                   "not expected: last.glb other.glb"},
        BadCommand{"NoValue", renderCornell("--out"), "--out: 1 required TEXT missing"},
        BadCommand{"TwoValues", renderCornell("--out out --out other"),
                   "--out: At Most 1 required but received 2"},
        BadCommand{"NotANumber", renderCornell("--out out --frames x"),
                   "--frames: Value x not in range 1 to 10000"},
        BadCommand{"NotWhole", renderCornell("--out out --light-frames 1.5"), "--light-frames = 1.5"},
        BadCommand{"Negative", renderCornell("--out out --seed-order -1"), "--seed-order = -1"},
        BadCommand{"NanAngle", renderCornell("--out out --cone-angle nan"), "'nan' is not a number"},
        BadCommand{"InfiniteExposure", renderCornell("--out out --exposure 1e39"), "is not a number above 0"},
        BadCommand{"VoxelSizeOfZero", renderCornell("--out out --voxel-size 0"),
                   "'0' is not a number above 0"},
        BadCommand{"VoxelSizeNan", benchCornell("--voxel-size nan"), "'nan' is not a number above 0"},
        BadCommand{"NoActiveVoxels", renderCornell("--out out --active-voxels 0"), "not a number above 0"},
        BadCommand{"NegativeDevice", renderCornell("--out out --device -1"), "not in range 0"},
        BadCommand{"NoLightFrames", renderCornell("--out out --light-frames 0"),
                   "must be between 1 and 1000\n"},
        BadCommand{"LightBeyondFloat", renderCornell("--out out --light intensity=1e39"),
                   "--light: color times"},
        BadCommand{"TimeWithoutAnimation", renderCornell("--out out --time 1"), "has no animation"},
        BadCommand{"FramesWithoutAnimation", renderCornell("--out out --frames 2 --fps 2"),
                   "has no animation"},
        BadCommand{"AnimationOfNone", renderCornell("--out out --animation run"), "it has no animation"},
        BadCommand{"UnknownAnimation", renderMoving("--animation walk"), "choose one of 0 (run)"},
        BadCommand{"FramesWithoutFps", renderMoving("--frames 2"), "--frames requires --fps"},
        BadCommand{"FpsWithoutFrames", renderMoving("--fps 2"), "--fps requires --frames"},
        BadCommand{"NoFrames", renderMoving("--frames 0 --fps 2"), "not in range 1 to 10000"},
        BadCommand{"FpsOfZero", renderMoving("--frames 2 --fps 0"), "not a number above 0"},
        BadCommand{"FpsInfinite", renderMoving("--frames 2 --fps inf"), "--fps: 'inf' is not a number"},
        BadCommand{"NegativeTime", renderMoving("--time -1"), "not in range 0"},
        BadCommand{"NanTime", renderMoving("--time nan"), "--time: 'nan' is not a number"},
        BadCommand{"FramesAndViews", renderMoving("--frames 2 --fps 2 --debug-views"), "leave out --frames"},
        BadCommand{"FramesAndSheet", renderMoving("--frames 2 --fps 2 --contact-sheet"),
                   "leave out --frames"},
        BadCommand{"ShadersPreset", onCornell("shaders", "--out out --preset best"),
                   "thesis, mobile, quality"},
        BadCommand{"InfoBackend", "info --backend direct3d", "egl, osmesa, zink"},
        BadCommand{"InfoScene", "info none.glb", "none.glb"},
        BadCommand{"InfoPreset", onCornell("info", "--preset best"), "thesis, mobile, quality"}),
    [](const ::testing::TestParamInfo<BadCommand>& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace vct::test
