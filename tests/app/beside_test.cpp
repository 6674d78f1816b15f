// Files beside a scene: its sky and its baked light, and other skies to choose.
#include <gtest/gtest.h>

#include "cli/program_run.h"
#include "stand_in/stand_in.h"
#include "support/moving_scenes.h"
#include "support/temporary_folder.h"

namespace vct::test {
namespace {

// A Radiance picture of 2 x 1 pixels. A pixel is a mantissa per channel and a common exponent, less 128.
std::string skyOf(const std::string& pixel) {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + pixel + pixel;
}

class Beside : public testing::Test {
  protected:
    Beside() { writeBytes(folder_.file("my.glb"), openFloor().glb()); }

    // The upper left pixel of the window, which shows the sky, after the app has logged `until`.
    glm::vec3 corner(const std::string& show, const std::string& until) {
        android_ = std::make_unique<StandIn>();
        android_->scenes = folder_.path();
        android_->intentExtra = "show display=off scene=my.glb grid=64 pixels=1 mode=gi " + show;
        android_->start(48, 36);
        android_->framesUntilLogged(" triangles");
        android_->framesUntilLogged(until);
        android_->frames(60);  // another sky has other programs, one of which is linked per frame
        android_->then([&] { android_->capture = true; });
        android_->frames(1);
        android_->run();
        EXPECT_EQ(android_->misuse, std::vector<std::string>{});
        return android_->screen.at(1, 1);
    }
    TemporaryFolder folder_;
    std::unique_ptr<StandIn> android_;
};

TEST_F(Beside, ASceneIsItsSkyAndOthersCanBeChosen) {
    const std::string red = "\x80\x08\x08\x80", blue = "\x08\x08\x80\x80";
    writeBytes(folder_.file("my.hdr"), skyOf(red));
    writeBytes(folder_.file("other.hdr"), skyOf(blue));
    const glm::vec3 own = corner("preset=thesis", " triangles");
    EXPECT_TRUE(android_->logged("the sky is that of scenes/my.hdr"));
    EXPECT_GT(own.r, 2.0F * own.b);
    const glm::vec3 other = corner("preset=thesis sky=other.hdr", "the sky is that of scenes/other.hdr");
    EXPECT_GT(other.b, 2.0F * other.r);
    EXPECT_EQ(android_->errors(), "");
    const glm::vec3 none = corner("preset=thesis sky=none.hdr", "there is no sky 'none.hdr'");
    EXPECT_GT(none.r, 2.0F * none.b) << "the scene's own sky stays";
    writeBytes(folder_.file("my.hdr"), skyOf(red).substr(0, 50));
    const glm::vec3 plain = corner("preset=thesis", " triangles");
    EXPECT_TRUE(android_->logged("cannot read the sky 'scenes/my.hdr'"));
    EXPECT_GT(plain.b, plain.r) << "the plain sky";
    EXPECT_EQ(android_->errors(), "");
}

TEST_F(Beside, ASceneIsItsBakedLight) {
    ProgramRun program;
    program.expectSuccess("bake '" + folder_.file("my.glb") + "'");
    corner("preset=mobile", " triangles");
    EXPECT_TRUE(android_->logged("the light beside scenes/my.glb is used"));
    corner("preset=quality", " triangles");
    EXPECT_TRUE(
        android_->logged("baked light is not used: the file beside scenes/my.glb is baked light of "
                         "other settings"));
    EXPECT_EQ(android_->errors(), "");
}

TEST_F(Beside, ThePanelFollowsTheDensity) {
    StandIn android;
    android.scenes = folder_.path();
    android.intentExtra = "show scene=my.glb preset=thesis grid=64 pixels=1 mode=phong steps=off";
    android.startUntilSceneShown(200, 120);
    Image before;
    android.then([&] { android.capture = true; });
    android.frames(2);
    android.then([&] { before = android.screen; });
    android.setDensity(480);
    android.frames(2);
    android.run();
    // Beside the panel's button, which is three times as large afterwards.
    const glm::ivec2 beside(110, 40);
    EXPECT_NE(before.at(beside.x, beside.y), android.screen.at(beside.x, beside.y));
    EXPECT_EQ(android.errors(), "");
    EXPECT_EQ(android.misuse, std::vector<std::string>{});
}

}  // namespace
}  // namespace vct::test
