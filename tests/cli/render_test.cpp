// The messages and files of `vct render`.
#include <gtest/gtest.h>

#include <filesystem>

#include "cli/program_run.h"
#include "image/image.h"
#include "support/errors.h"
#include "support/gltf_builder.h"

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
    expectMentions(program.err, {"warning: the narrowest 2 % of the surface are up to 1 cm thick "
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

TEST(Render, ASceneAloneIsRenderedIntoAFolderOfItsName) {
    ProgramRun program;
    std::filesystem::copy_file(ProgramRun::cornell, program.folder.file("my box.glb"));
    const std::string tiny = " --mode phong --size 16x16 --grid 64 --samples 1";
    program.expectSuccess("'my box.glb'" + tiny);
    EXPECT_EQ(program.folder.list("out/my box"), (std::vector<std::string>{"phong.exr", "phong.png"}));
    expectMentions(program.err, {"wrote out/my box/phong.exr, out/my box/phong.png"});
    const std::string byName = readBytes(program.folder.file("out/my box/phong.png"));
    program.expectSuccess("'my box.glb'" + tiny + " --out deep/picture.png");
    EXPECT_EQ(program.folder.list("deep"), std::vector<std::string>{"picture.png"});
    EXPECT_EQ(readBytes(program.folder.file("deep/picture.png")), byName);
    program.expectSuccess(tiny.substr(1) + " 'my box.glb' --out picture.exr");
    EXPECT_EQ(readBytes(program.folder.file("picture.exr")),
              readBytes(program.folder.file("out/my box/phong.exr")));
}

TEST(Render, APictureHasTheShapeOfItsCamera) {
    ProgramRun program;
    GltfBuilder scene;
    scene.triangle();
    for (const double aspect : {16.0 / 9.0, 0.0001}) {
        scene.node(
            {{"translation", {0, 0, 3}},
             {"camera", scene.add("cameras", {{"type", "perspective"},
                                              {"perspective",
                                               {{"yfov", 0.7}, {"znear", 0.1}, {"aspectRatio", aspect}}}})}});
    }
    writeBytes(program.folder.file("a.glb"), scene.glb());
    const auto sizeOf = [&](const std::string& options) {
        program.expectSuccess("a.glb --out a.exr --mode phong --grid 64 --samples 1 " + options);
        const Image image = readImage(program.folder.file("a.exr"));
        return glm::ivec2(image.width, image.height);
    };
    EXPECT_EQ(sizeOf(""), glm::ivec2(534, 300));
    EXPECT_EQ(program.err.find("times as wide as high"), std::string::npos) << program.err;
    EXPECT_EQ(sizeOf("--camera 1"), glm::ivec2(142, 1132)) << "at most eight times as high as wide";
    EXPECT_EQ(sizeOf("--camera eye=0,0,3"), glm::ivec2(400, 400));
    EXPECT_EQ(sizeOf("--size 64x64"), glm::ivec2(64, 64));
}

TEST(Render, ASceneOfKilometresWhosePartsAreAsLargeIsAskedForItsUnit) {
    ProgramRun program;
    GltfBuilder scene;
    scene.triangle();
    scene.document["nodes"][0]["scale"] = {4000, 4000, 4000};
    writeBytes(program.folder.file("a.glb"), scene.glb());
    program.expectSuccess("a.glb --mode phong --grid 64 --samples 1 --size 16x16");
    expectMentions(program.err, {"4000 x 4000 x 0 m", "millimetres", "--scale 0.001"});
    program.expectSuccess("a.glb --mode phong --grid 64 --samples 1 --size 16x16 --scale 0.001");
    EXPECT_EQ(program.err.find("millimetres"), std::string::npos) << program.err;
    expectMentions(program.err, {"voxels of 6.78 cm"});
}

// Along the edge of a surface that is far brighter than white.
TEST(Render, ThePngOfSeveralSamplesHasSmoothEdges) {
    ProgramRun program;
    GltfBuilder scene;
    scene.triangle();
    writeBytes(program.folder.file("a.glb"), scene.glb());
    program.expectSuccess(
        "a.glb --mode phong --grid 64 --size 64x64 --samples 4 --sky 1,1,1 --background 0,0,0 --exposure "
        "1000 "
        "--out a.png");
    int white = 0, between = 0;
    for (const glm::vec3& pixel : readImage(program.folder.file("a.png")).pixels) {
        white += pixel.g > 0.9F;
        between += pixel.g > 0.2F && pixel.g < 0.8F;
    }
    EXPECT_GT(white, 100);
    EXPECT_GT(between, 40);
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
}

}  // namespace
}  // namespace vct::test
