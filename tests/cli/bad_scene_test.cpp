// What a person sees who hands `vct render` a scene that cannot be rendered: one error, exit status 1, and
// not a single file.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "cli/program_run.h"
#include "scene/gltf.h"
#include "support/gltf_builder.h"

namespace vct::test {
namespace {

class BadScene : public ::testing::Test {
  protected:
    // Runs the program on `file`; returns its exit status and keeps what it printed.
    int render(const std::string& name, const Bytes& file, const std::string& options = "--grid 64",
               const std::string& before = "") {
        writeBytes(folder.file(name), std::string(file.begin(), file.end()));
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
        EXPECT_NE(text.find(words), std::string::npos) << text;
        const std::filesystem::path out = folder.path() + "/out";
        if (std::filesystem::exists(out)) {
            EXPECT_TRUE(std::filesystem::is_empty(out)) << "something half-written is left";
        }
    }

    static Bytes triangleGlb(const std::vector<float>& positions, bool camera = true) {
        GltfBuilder builder;
        const int position = builder.floats(positions);
        const int mesh = builder.mesh({{"attributes", {{"POSITION", position}}}});
        builder.node({{"mesh", mesh}});
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

TEST_F(BadScene, AGoodOneRendersSoThatTheOthersCanFail) {
    EXPECT_EQ(render("good.glb", triangleGlb({0, 0, 0, 1, 0, 0, 0, 1, 0})), 0) << text;
    EXPECT_EQ(errors(), 0) << text;
}

TEST_F(BadScene, Truncated) {
    Bytes file = cornell();
    file.resize(file.size() / 2);
    expectOneError(render("truncated.glb", file), "truncated.glb");
}

TEST_F(BadScene, BitFlipsEndInAPictureOrInOneError) {
    std::mt19937 random(7);
    int failures = 0;
    for (int i = 0; i < 12; ++i) {
        Bytes file = cornell();
        // The header and the JSON: a flip in a vertex is only another scene.
        for (int flip = 0; flip < 3; ++flip)
            file[random() % 2000] ^= static_cast<unsigned char>(1U << (random() % 8));
        const int status = render("flipped.glb", file, "--mode phong");
        EXPECT_TRUE(status == 0 || (status == 1 && errors() == 1)) << status << ": " << text;
        failures += status != 0;
    }
    EXPECT_GT(failures, 0);
}

TEST_F(BadScene, MissingTexture) {
    GltfBuilder builder;
    const int position = builder.floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int uv = builder.floats({0, 0, 1, 0, 0, 1}, "VEC2");
    builder.add("images", {{"uri", "not-there.png"}});
    builder.add("textures", {{"source", 0}});
    builder.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    builder.node({{"mesh", builder.mesh({{"attributes", {{"POSITION", position}, {"TEXCOORD_0", uv}}},
                                         {"material", 0}})}});
    expectOneError(render("texture.glb", builder.glb()), "not-there.png");
}

TEST_F(BadScene, NotANumberAndHugeVertices) {
    expectOneError(render("nan.glb", triangleGlb({0, 0, 0, 1, NAN, 0, 0, 1, 0})), "nan.glb: mesh 0 has a");
    expectOneError(render("huge.glb", triangleGlb({0, 0, 0, 3e38F, 0, 0, 0, 3e38F, -3e38F})), "huge.glb");
}

TEST_F(BadScene, IndexOutOfRange) {
    GltfBuilder builder;
    const int position = builder.floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int indices = builder.accessor(std::vector<std::uint16_t>{0, 1, 3}, uint16, "SCALAR");
    builder.node({{"mesh", builder.mesh({{"attributes", {{"POSITION", position}}}, {"indices", indices}})}});
    expectOneError(render("index.glb", builder.glb()), "index.glb");
}

TEST_F(BadScene, ZeroTriangles) {
    GltfBuilder builder;
    builder.node({{"translation", {0, 0, 0}}});
    expectOneError(render("empty.glb", builder.glb()), "empty.glb");
}

TEST_F(BadScene, NoCameraSuggestsOneThatWorks) {
    const Bytes file = triangleGlb({0, 0, 0, 1, 0, 0, 0, 1, 0}, false);
    expectOneError(render("camera.glb", file), "--camera eye=");
    const std::size_t at = text.find("--camera eye=");
    const std::string suggestion = text.substr(at, text.find_first_of(" ;\n'`", at + 10) - at);
    EXPECT_EQ(render("camera.glb", file, suggestion), 0) << suggestion << "\n" << text;
}

TEST_F(BadScene, GridThatDoesNotFitInMemory) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the address sanitizer reserves more address space than any limit that a test could set";
#endif
    expectOneError(
        render("good.glb", triangleGlb({0, 0, 0, 1, 0, 0, 0, 1, 0}), "--grid 512", "ulimit -v 1200000;"),
        "a coarser grid");
}

TEST_F(BadScene, VoxelsThatNoGridGives) {
    const Bytes file = triangleGlb({0, 0, 0, 1, 0, 0, 0, 1, 0});
    expectOneError(render("good.glb", file, "--voxel-size 1e-6"), "512^3, gives this scene voxels of");
    EXPECT_NE(render("good.glb", file, "--voxel-size 0.1 --grid 64"), 0);
    EXPECT_NE(text.find("excludes"), std::string::npos) << text;
}

TEST_F(BadScene, GridsThatFollowFromAGoodSceneAreNamed) {
    const Bytes file = triangleGlb({0, 0, 0, 1, 0, 0, 0, 1, 0});  // 1 m
    EXPECT_EQ(render("good.glb", file, "--preset mobile --grid auto --mode phong"), 0) << text;
    EXPECT_NE(text.find("grid 64: voxels of 1.69 cm; the narrowest 2 % of the surface"), std::string::npos)
        << text;
    EXPECT_EQ(render("good.glb", file, "--voxel-size 0.01 --mode phong"), 0) << text;
    EXPECT_NE(text.find("grid 128: voxels of 8.13 mm"), std::string::npos) << text;
}

TEST_F(BadScene, ListThatIsTooSmallNamesTheSizeThatIsNeeded) {
    expectOneError(render("cornell.glb", cornell(), "--grid 64 --active-voxels 100"), "active voxels");
}

// As on a full disk.
TEST_F(BadScene, OutputThatDoesNotFitLeavesNothing) {
    expectOneError(render("cornell.glb", cornell(), "--mode phong", "ulimit -f 4;"),
                   "cannot write 'out/phong.exr'");
}

TEST_F(BadScene, UnreachableDriverLacksSomethingAndNamesIt) {
    const int status = render("good.glb", triangleGlb({0, 0, 0, 1, 0, 0, 0, 1, 0}), "",
                              "MESA_GLES_VERSION_OVERRIDE=3.1 "
                              "MESA_EXTENSION_OVERRIDE='-GL_OES_shader_image_atomic -GL_EXT_geometry_shader "
                              "-GL_OES_geometry_shader -GL_ARB_shader_image_load_store'");
    if (status == 0) GTEST_SKIP() << "only Mesa can be told to lack an extension";
    expectOneError(status, "shader_image_atomic");
}

}  // namespace
}  // namespace vct::test
