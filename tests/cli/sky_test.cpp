// The option --environment, and the light of scenes that have none.
#include <gtest/gtest.h>

#include "cli/program_run.h"
#include "core/files.h"
#include "image/compare.h"
#include "image/image.h"
#include "support/errors.h"
#include "support/pictures.h"

namespace vct::test {
namespace {

const std::string patio = VCT_SOURCE_DIR "/assets/patio";

std::string renderPatio(const std::string& options) {
    return "render " + patio + ".glb --out out --mode gi --preset mobile --light-frames 2 --size 16x16 " +
           options;
}

void write(const ProgramRun& program, const std::string& name, const std::string& text) {
    replaceFile(program.folder.file(name), text);
}

TEST(SkyOption, ABadFileIsOneErrorThatNamesFileCauseAndRemedy) {
    const std::string good = readBytes(patio + ".hdr");
    const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
    Image negative(4, 2, glm::vec3(1.0F));
    negative.at(1, 0).g = -1.0F;
    struct Case {
        std::string name, bytes, cause, remedy;
    };
    const Case cases[] = {
        {"truncated.hdr", good.substr(0, good.size() - 100), "it is incomplete", "make it again"},
        {"header.hdr", good.substr(0, 20), "its header is incomplete", "make it again"},
        // The end of a run-length row is missing: stb_image would search for it for ever.
        {"endless.hdr", header + "-Y 4 +X 8\n" + std::string("\2\2\0\x08\x88\1", 6), "it is incomplete",
         "make it again"},
        {"run.hdr", header + "-Y 4 +X 8\n" + std::string("\2\2\0\x08\xff\1", 6) + std::string(99, '\1'),
         "a row of it is damaged", "make it again"},
        {"square.hdr", header + "-Y 2 +X 2\n" + std::string(16, '\x80'), "it is 2 x 2 pixels",
         "twice as wide as high"},
        {"huge.hdr", header + "-Y 100000 +X 200000\n", "200000 x 100000", "make it again"},
        {"empty.hdr", "", "the file is empty", "make it again"},
    };
    for (const Case& bad : cases) {
        ProgramRun program;
        write(program, bad.name, bad.bytes);
        EXPECT_EQ(program.run(renderPatio("--environment " + bad.name)), 1) << bad.name;
        EXPECT_EQ(lineCount(program.err), 1) << program.err;
        expectMentions(program.err, {"error: ", bad.name, bad.cause, bad.remedy});
    }
    ProgramRun program;
    writeExr(program.folder.file("negative.exr"), negative);
    EXPECT_EQ(program.run(renderPatio("--environment negative.exr")), 1);
    expectMentions(program.err, {"negative.exr", "pixel 1,0", "give radiance from 0 on"});
    EXPECT_NE(program.run(renderPatio("--sky 1,1,1 --environment " + patio + ".hdr")), 0);
    expectMentions(program.err, {"--sky", "--environment"});
}

TEST(SkyOption, ASceneWithoutLightGetsASunAndASkyThatOptionsRepeat) {
    ProgramRun program;
    ASSERT_EQ(program.run(renderPatio("")), 0) << program.err;
    const std::size_t at = program.err.find("--light direction=");
    ASSERT_NE(at, std::string::npos) << program.err;
    const std::string given = program.err.substr(at, program.err.find('\n', at) - at);
    const Image byDefault = readImage(program.folder.file("out/gi.exr"));
    ASSERT_EQ(program.run(renderPatio(given)), 0) << program.err;
    EXPECT_EQ(program.err.find("the scene has no light of its own"), std::string::npos);
    expectSameInHalves(readImage(program.folder.file("out/gi.exr")), byDefault);
    // A given sky is light, and no sun is added.
    ASSERT_EQ(program.run(renderPatio("--environment " + patio + ".hdr")), 0) << program.err;
    EXPECT_EQ(program.err.find("the scene has no light of its own"), std::string::npos);
    EXPECT_GT(compareImages(readImage(program.folder.file("out/gi.exr")), byDefault, 0.01F).fraction, 0.5);
}

}  // namespace
}  // namespace vct::test
