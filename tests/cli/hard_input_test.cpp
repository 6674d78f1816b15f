// Unusual inputs and surroundings, and the messages about them.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "cli/program_run.h"
#include "support/errors.h"
#include "support/gltf_builder.h"

namespace vct::test {
namespace {

constexpr const char* quick = " --size 16x16 --grid 64 --mode phong --out out ";

std::string renderQuickly(const std::string& scene, const std::string& options = "") {
    return "render '" + scene + "'" + quick + options;
}

TEST(HardInput, OnlyTheOptionLetsASceneNameFilesOutsideOfItsFolder) {
    ProgramRun program;
    GltfBuilder builder;
    builder.triangle();
    std::filesystem::create_directory(program.folder.file("scene"));
    writeBytes(program.folder.file("scene/a.gltf"), builder.gltf("../a.bin"));
    writeBytes(program.folder.file("a.bin"), builder.binary);
    for (const char* command : {"render scene/a.gltf --out out --size 16x16 --mode phong --grid 64",
                                "info scene/a.gltf --print-camera", "bench scene/a.gltf --repeat 1",
                                "shaders scene/a.gltf --out out --preset thesis"}) {
        EXPECT_EQ(program.run(command), 1) << command;
        EXPECT_EQ(lineCount(program.err), 1) << program.err;
        expectMentions(program.err, {"a.bin, outside of the scene's folder", "(--allow-outside)"});
    }
    program.expectSuccess("render scene/a.gltf --allow-outside" + std::string(quick));
    program.expectSuccess("info scene/a.gltf --print-camera --allow-outside");
}

TEST(HardInput, NamesThatAreNotUtf8OrEndInADotAreNames) {
    ProgramRun program;
    GltfBuilder builder;
    builder.triangle();
    const std::string name = "a\xFF\xFE.glb";
    writeBytes(program.folder.file(name), builder.glb());
    program.expectSuccess(renderQuickly(name, "--timings t.json"));
    EXPECT_TRUE(program.json("t.json").is_object());
    EXPECT_EQ(program.run("render none.gltf. --out out"), 1);
    expectMentions(program.err, {"none.gltf.: there is no such file"});
    EXPECT_EQ(program.run("render . --out out"), 1);
    expectMentions(program.err, {"cannot read .: it is not a file"});
}

TEST(HardInput, PipesAreNeitherScenesNorShaders) {
    ProgramRun program;
    ASSERT_EQ(mkfifo(program.folder.file("pipe.glb").c_str(), 0600), 0);
    EXPECT_EQ(program.run("render pipe.glb --out out", "timeout 20"), 1);
    expectMentions(program.err, {"pipe.glb: it is not a file"});
    std::filesystem::copy(VCT_SOURCE_DIR "/shaders", program.folder.file("shaders"),
                          std::filesystem::copy_options::recursive);
    const std::string shader = program.folder.file("shaders/shared/layout.h");
    ASSERT_TRUE(std::filesystem::remove(shader));
    ASSERT_EQ(mkfifo(shader.c_str(), 0600), 0);
    EXPECT_EQ(program.run(renderQuickly(ProgramRun::cornell), "VCT_SHADER_DIR=shaders timeout 60"), 1);
    expectMentions(program.err, {"cannot read the shader shaders/shared/layout.h"});
}

TEST(HardInput, StandardOutputThatIsFullIsAnError) {
    ProgramRun program;
    const std::string info = std::string("info --print-camera ") + ProgramRun::cornell;
    EXPECT_EQ(program.run(info, "sh -c '\"$0\" \"$@\" > /dev/full'"), 1);
    expectMentions(program.err, {"error: cannot write to standard output: No space left on device"});
}

TEST(HardInput, APictureTooLargeForMemoryIsOneErrorAtOnce) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the address sanitizer reserves more address space than any limit that a test could set";
#endif
    ProgramRun program;
    const std::string large =
        std::string("render ") + ProgramRun::cornell + " --mode phong --grid 64 --out out ";
    EXPECT_EQ(program.run(large + "--size 8192x8192", "ulimit -v 3000000;"), 1);
    EXPECT_EQ(lineCount(program.err), 1) << program.err;
    expectMentions(program.err, {"not enough memory for a picture of 8192 x 8192 pixels", "(--size)"});
    EXPECT_EQ(program.folder.list(), std::vector<std::string>{});
}

TEST(HardInput, AFolderInThePlaceOfAPictureIsFoundBeforeRendering) {
    struct Case {
        const char *folder, *options;
    };
    for (const Case& test :
         {Case{"ao.png", "--mode phong,ao"}, Case{"contact_sheet.png", "--contact-sheet"},
          Case{"cone_shadow.exr", "--light-parts"}, Case{"debug_views/voxels.png", "--debug-views"}}) {
        ProgramRun program;
        std::filesystem::create_directories(program.folder.file(std::string("out/") + test.folder));
        const std::string options = std::string(" --size 16x16 --grid 64 --out out ") + test.options;
        EXPECT_EQ(program.run(std::string("render ") + ProgramRun::cornell + options), 1) << test.folder;
        EXPECT_EQ(lineCount(program.err), 1) << program.err;
        expectMentions(program.err, {std::string("cannot write 'out/") + test.folder, "Is a directory"});
    }
    ProgramRun program;
    std::filesystem::create_directories(program.folder.file("out/phong_0001.png"));
    EXPECT_EQ(
        program.run("render '" VCT_SOURCE_DIR "/assets/moving.glb' --frames 2 --fps 1" + std::string(quick)),
        1);
    EXPECT_EQ(lineCount(program.err), 1) << program.err;
    expectMentions(program.err, {"out/phong_0001.png"});
}

TEST(HardInput, NoCameraIsBlamedThatNobodyGave) {
    ProgramRun program;
    GltfBuilder builder;
    builder.triangle();
    builder.document["nodes"][0]["translation"] = {1e15, 1e15, 1e15};
    writeBytes(program.folder.file("far.glb"), builder.glb());
    EXPECT_EQ(program.run("info far.glb --print-camera"), 1);
    expectMentions(program.err,
                   {"cannot frame the scene far.glb", "too far from the origin", "move it nearer"});
    EXPECT_EQ(program.run(renderQuickly(ProgramRun::cornell, "--camera eye=1,2,3,target=1,2,3")), 1);
    expectMentions(program.err, {"the camera's eye and target", "(--camera)"});

    // A file's camera whose near plane is at an absurd distance.
    GltfBuilder near;
    near.triangle();
    near.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1e300}}}});
    near.node({{"camera", 0}, {"translation", {0, 0, 2}}});
    writeBytes(program.folder.file("near.glb"), near.glb());
    program.expectSuccess("info near.glb --print-camera");
}

TEST(HardInput, ADriverThatIsTooOldIsNamed) {
    ProgramRun program;
    if (program.run("info", "MESA_GLES_VERSION_OVERRIDE=3.0") == 0)
        GTEST_SKIP() << "only Mesa can be told to be older";
    expectMentions(program.err, {"OpenGL ES 3.0 Mesa", "is too old", "update the driver", "(--backend)"});
    EXPECT_EQ(program.err.find("install"), std::string::npos) << program.err;
}

TEST(Output, AnInterruptedRunLeavesNothing) {
    ProgramRun program;
    const std::string slow = std::string("render ") + ProgramRun::cornell +
                             " --size 2000x2000 --preset quality --mode gi --out deep/er/out";
    EXPECT_EQ(program.run(slow, "timeout 2"), 124) << program.err;
    EXPECT_EQ(program.folder.list(), std::vector<std::string>{});
}

}  // namespace
}  // namespace vct::test
