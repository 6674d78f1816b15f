// `vct compare`: comparison of pictures and its exit status.
#include "image/compare.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cli/program_run.h"

namespace vct::test {
namespace {

class CompareCommand : public ::testing::Test {
  protected:
    void SetUp() override {
        Image image(10, 10, glm::vec3(srgbDecode(100.0F / 255.0F)));
        writePng(folder.file("a.png"), image);
        image.at(4, 5) = glm::vec3(srgbDecode(107.0F / 255.0F));
        writePng(folder.file("b.png"), image);
        writePng(folder.file("small.png"), Image(9, 10));
        Image bright(10, 10, glm::vec3(2.0F));
        writeExr(folder.file("a.exr"), bright);
        bright.at(7, 3).r = std::nanf("");
        writeExr(folder.file("nan.exr"), bright);
    }

    int run(const std::string& arguments) {
        const int status = program.run("compare " + arguments);
        text = program.out + program.err;
        return status;
    }
    bool says(const std::string& words) const { return text.find(words) != std::string::npos; }

    ProgramRun program;
    const TemporaryFolder& folder = program.folder;
    std::string text;
};

TEST_F(CompareCommand, ExitStatusFollowsBothNumbers) {
    EXPECT_EQ(run("a.png a.png --max-difference 0 --max-fraction 0"), 0) << text;
    EXPECT_EQ(run("a.png b.png --max-difference 7/255 --max-fraction 0"), 0) << text;
    EXPECT_EQ(run("a.png b.png --max-difference 6/255 --max-fraction 0.01"), 0) << text;
    EXPECT_EQ(run("a.png b.png --max-difference 6/255 --max-fraction 0.0099 --diff diff.png"), 1);
    EXPECT_TRUE(says("0.027451 (7/255)")) << text;
    EXPECT_GT(readImage(folder.file("diff.png")).at(4, 5).g, srgbDecode(0.5F));
}

TEST_F(CompareCommand, PicturesThatCannotBeComparedFailWithTheReason) {
    const std::string loose = " --max-difference 1 --max-fraction 1";
    EXPECT_EQ(run("a.png none.png" + loose), 1);
    EXPECT_TRUE(says("none.png: there is no such file")) << text;
    EXPECT_EQ(run("a.png small.png" + loose), 1);
    EXPECT_TRUE(says("9 x 10")) << text;
    EXPECT_EQ(run("a.exr nan.exr" + loose), 1);
    EXPECT_TRUE(says("second picture has a NaN or an infinity at pixel (7, 3)")) << text;
    EXPECT_EQ(run("a.png a.exr" + loose), 1);
    EXPECT_TRUE(says("one is a PNG, the other an EXR")) << text;
}

TEST_F(CompareCommand, BadTolerancesAreRefused) {
    for (const char* difference : {"x", "5/", "5/0", "-1", "nan", "inf", "5/255x", "256/255"})
        EXPECT_NE(run("a.png a.png --max-fraction 0 --max-difference=" + std::string(difference)), 0)
            << difference;
    for (const char* fraction : {"1.5", "-1", "nan", "x"})
        EXPECT_NE(run("a.png a.png --max-difference 0 --max-fraction=" + std::string(fraction)), 0)
            << fraction;
    EXPECT_NE(run("a.png a.png"), 0);
}

}  // namespace
}  // namespace vct::test
