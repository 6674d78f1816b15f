// Choices from the text of an intent.
#include "app/choices.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace vct::app {
namespace {

// The grid of another preset may be too large for a phone.
TEST(Choices, APresetBringsItsOwnGrid) {
    Choices choices;
    choosePreset(choices, "mobile");
    EXPECT_EQ(choices.preset, "mobile");
    EXPECT_EQ(choices.grid, presetSettings("mobile").grid);
    EXPECT_NE(choices.grid, presetSettings("thesis").grid);
    EXPECT_THROW(choosePreset(choices, "best"), Error);
    EXPECT_EQ(choices.preset, "mobile");
}

TEST(Choices, AGridInWordsStandsOverThePresets) {
    EXPECT_EQ(showRequestFromText("show preset=mobile").choices.grid, presetSettings("mobile").grid);
    EXPECT_EQ(showRequestFromText("show preset=mobile grid=128").choices.grid, 128);
    EXPECT_EQ(showRequestFromText("show grid=128 preset=mobile").choices.grid, 128);
    EXPECT_THROW(showRequestFromText("show grid=100"), Error);
}

TEST(Choices, ATimeStopsTheAnimationThere) {
    EXPECT_TRUE(showRequestFromText("show scene=a.glb").choices.play);
    const ShowRequest request = showRequestFromText("show time=1.5");
    EXPECT_FALSE(request.choices.play);
    EXPECT_EQ(request.timeS, 1.5);
    for (const char* wrong : {"show time=", "show time=-1", "show time=nan", "show time=2s"})
        EXPECT_THROW(showRequestFromText(wrong), Error) << wrong;
}

TEST(Choices, LightsAreSwitchedAndTheSkyIsChosenInWords) {
    const Choices choices = showRequestFromText("show sky=plain lights-off=1,16").choices;
    EXPECT_EQ(choices.sky, Sky::plain);
    EXPECT_EQ(choices.lightsOff.to_ulong(), 0x8001UL);
    EXPECT_NE(choices, Choices());
    for (const char* wrong :
         {"show sky=blue", "show sky=", "show lights-off=0", "show lights-off=17", "show lights-off=1,a"})
        EXPECT_THROW(showRequestFromText(wrong), Error) << wrong;
}

TEST(Choices, ASkyIsTheScenesOrOfItsLightUnlessItIsDark) {
    DirectionalLight sun;
    sun.intensity = 3000.0F;
    const glm::vec3 sceneSky(1.0F, 2.0F, 3.0F);
    Choices choices;
    EXPECT_EQ(skyRadianceFor(choices, sceneSky, sun), sceneSky);
    choices.sky = Sky::plain;
    EXPECT_NEAR(skyRadianceFor(choices, sceneSky, sun).g, 3000.0F * 0.25F / 3.14159265F, 0.1F);
    choices.sky = Sky::dark;
    EXPECT_EQ(skyRadianceFor(choices, sceneSky, sun), glm::vec3(0.0F));
}

}  // namespace
}  // namespace vct::app
