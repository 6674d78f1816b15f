// A scene that cannot be rendered gives one error, exit status 1 and no files. Errors of the file itself are
// in gltf_errors_test.cpp and gltf_fuzz_test.cpp.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "cli/program_run.h"
#include "scene/gltf.h"
#include "support/errors.h"
#include "support/gltf_builder.h"

namespace vct::test {
namespace {

class BadScene : public ::testing::Test {
  protected:
    // Runs the program on `file`; returns its exit status and keeps what it printed.
    int render(const std::string& name, const Bytes& file, const std::string& options = "--grid 64",
               const std::string& before = "") {
        writeBytes(folder.file(name), file);
        const int status = program.run("render " + name + " --out out --size 32x32 " + options, before);
        text = program.out + program.err;
        return status;
    }

    int errors() const {
        int count = 0;
        for (std::size_t at = text.find("error:"); at != std::string::npos; at = text.find("error:", at + 1))
            ++count;
        return count;
    }

    void expectOneError(int status, const std::string& words) {
        EXPECT_EQ(status, 1) << text;
        EXPECT_EQ(errors(), 1) << text;
        expectMentions(text, {words});
        const std::filesystem::path out = folder.path() + "/out";
        if (std::filesystem::exists(out)) {
            EXPECT_TRUE(std::filesystem::is_empty(out)) << "something half-written is left";
        }
    }

    static Bytes triangleGlb(bool camera = true) {
        GltfBuilder builder;
        builder.triangle();
        if (camera) {
            builder.add("cameras",
                        {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}});
            builder.node({{"camera", 0}, {"translation", {0, 0, 5}}});
        }
        return builder.glb();
    }
    static Bytes cornell() { return readFileFromDisk(VCT_SOURCE_DIR "/assets/cornell.glb"); }

    ProgramRun program;
    const TemporaryFolder& folder = program.folder;
    std::string text;
};

TEST_F(BadScene, IsOneErrorIfItIsTruncated) {
    Bytes file = cornell();
    file.resize(file.size() / 2);
    expectOneError(render("truncated.glb", file), "truncated.glb");
}

TEST_F(BadScene, WithoutACameraHasAViewThatAnOptionRepeats) {
    const Bytes file = triangleGlb(false);
    EXPECT_EQ(render("camera.glb", file, "--mode phong"), 0) << text;
    const std::size_t at = text.find("--camera eye=");
    ASSERT_NE(at, std::string::npos) << text;
    const std::string option = text.substr(at, text.find('\n', at) - at);
    const std::string picture = readBytes(folder.file("out/phong.exr"));
    EXPECT_EQ(render("camera.glb", file, "--mode phong " + option), 0) << option << "\n" << text;
    EXPECT_EQ(text.find("--camera"), std::string::npos) << text;
    EXPECT_TRUE(readBytes(folder.file("out/phong.exr")) == picture) << option;
    // Every other command has the same view.
    for (const char* command : {"info camera.glb --size 32x32 --print-camera",
                                "shaders camera.glb --size 32x32 --preset mobile --out shaders",
                                "bench camera.glb --size 32x32 --preset mobile --grid 64 --repeat 1"}) {
        EXPECT_EQ(program.run(command), 0) << program.err;
        expectMentions(program.err, {option + "\n"});
    }
    EXPECT_EQ(program.run("info camera.glb --print-camera --camera 3"), 1);
    expectMentions(program.err, {"no camera", "leave out --camera"});
}

TEST_F(BadScene, GetsAWarningIfItsCameraIsNotUsedAsItIs) {
    GltfBuilder builder;
    builder.triangle();
    builder.add("cameras", {{"type", "orthographic"},
                            {"name", "plan"},
                            {"orthographic", {{"xmag", 2}, {"ymag", 1}, {"zfar", 9}, {"znear", 1}}}});
    builder.node({{"camera", 0}, {"translation", {0.3, 0.3, 5}}});
    EXPECT_EQ(render("plan.glb", builder.glb(), "--mode phong --grid 64"), 0) << text;
    expectMentions(text,
                   {"warning: orthographic camera 0 (plan) is drawn in perspective",
                    "camera \"plan\" is made for pictures 2 times as wide as high, and this one is 1 times"});
}

TEST_F(BadScene, IsOneErrorIfTheGridDoesNotFitInMemory) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the address sanitizer reserves more address space than any limit that a test could set";
#endif
    expectOneError(render("good.glb", triangleGlb(), "--grid 512", "ulimit -v 1200000;"), "a coarser grid");
}

TEST_F(BadScene, IsOneErrorIfTheListOfVoxelsIsTooSmall) {
    expectOneError(render("cornell.glb", cornell(), "--grid 64 --active-voxels 100"), "active voxels");
}

// The limit acts as a full disk.
TEST_F(BadScene, LeavesNoFileIfThePicturesDoNotFit) {
    expectOneError(render("cornell.glb", cornell(), "--mode phong", "ulimit -f 4;"),
                   "cannot write 'out/phong.exr'");
}

TEST_F(BadScene, IsOneErrorIfTheDriverLacksAnExtension) {
    const int status = render("good.glb", triangleGlb(), "",
                              "MESA_GLES_VERSION_OVERRIDE=3.1 "
                              "MESA_EXTENSION_OVERRIDE='-GL_OES_shader_image_atomic -GL_EXT_geometry_shader "
                              "-GL_OES_geometry_shader -GL_ARB_shader_image_load_store'");
    if (status == 0) GTEST_SKIP() << "only Mesa can be told to lack an extension";
    expectOneError(status, "shader_image_atomic");
}

}  // namespace
}  // namespace vct::test
