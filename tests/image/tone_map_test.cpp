#include "image/tone_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "shared/tone_map.h"
#include "support/errors.h"

namespace vct::test {
namespace {

glm::vec3 neutral(const glm::vec3& color) {
    return shared::neutralToneMapped(color);
}

// The three parts of the curve, the points where they meet, and the limit.
TEST(NeutralToneMap, KeepsBaseColoursAndCompressesBrighterOnes) {
    const auto near = [](const glm::vec3& a, const glm::vec3& b) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(a[c], b[c], 1e-6F);
    };
    near(neutral({0, 0, 0}), {0, 0, 0});
    near(neutral({0.04F, 0.5F, 0.2F}), {0.01F, 0.47F, 0.17F});  // .04 - 6.25 .04^2
    near(neutral({0.08F, 0.08F, 0.08F}), {0.04F, 0.04F, 0.04F});
    near(neutral({0.8F, 0.3F, 0.1F}), {0.76F, 0.26F, 0.06F});
    // 1 - .24^2 / (.96 + .24 - .76), a grey stays grey.
    near(neutral({1, 1, 1}), glm::vec3(1.0F - 0.0576F / 0.44F));
    // A saturated colour fades: 2 - 0 (its least channel is 0), pressed to 1 - .0576 / 1.48.
    const float pressed = 1.0F - 0.0576F / 1.48F, share = 1.0F / (0.15F * (2.0F - pressed) + 1.0F);
    near(neutral({2, 0, 0}), {pressed, pressed * (1 - share), pressed * (1 - share)});
    float last = 0.0F;
    for (float value = 0.0F; value < 1e4F; value = value * 1.1F + 1e-3F) {
        const float shown = neutral(glm::vec3(value)).r;
        EXPECT_GE(shown, last);
        EXPECT_LE(shown, 1.0F);
        last = shown;
    }
    EXPECT_GT(last, 0.999F);
}

// AgX shows middle grey at half of the display's code. The matrices of Hill's fit keep grey, so its curve
// alone decides.
TEST(ToneMaps, OfFilmKeepGreyGreyAndMiddleGreyWhereItIsKnown) {
    const auto known = [](const glm::vec3& shown, float value, float tolerance) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(shown[c], value, tolerance);
    };
    known(shared::agxToneMapped(glm::vec3(0.18F)), std::pow(0.5F, 2.2F), 0.005F);
    known(shared::agxToneMapped(glm::vec3(0.0F)), 0.0F, 1e-3F);
    known(shared::agxToneMapped(glm::vec3(1e6F)), 1.0F, 0.01F);
    // (.18 (.18 + .0245786) - .000090537) / (.18 (.983729 .18 + .432951) + .238081)
    known(shared::acesToneMapped(glm::vec3(0.18F)), 0.10559F, 1e-4F);
    known(shared::acesToneMapped(glm::vec3(0.0F)), 0.0F, 1e-3F);
    known(shared::acesToneMapped(glm::vec3(1e30F)), 1.0F, 0.02F);
    for (const auto curve : {shared::agxToneMapped, shared::acesToneMapped}) {
        float last = -1.0F;
        for (float value = 0.0F; value < 1e4F; value = value * 1.1F + 1e-3F) {
            const glm::vec3 shown = curve(glm::vec3(value));
            EXPECT_GE(shown.r, last);
            EXPECT_NEAR(shown.g, shown.r, 0.005F);
            EXPECT_NEAR(shown.b, shown.r, 0.005F);
            last = shown.r;
        }
        // Bright red turns white gradually; the neutral curve is compared above.
        EXPECT_LT(curve({1, 0, 0}).g, curve({20, 0, 0}).g);
    }
}

TEST(ToneMaps, AreChosenByName) {
    const Image image(1, 1, glm::vec3(2.0F, 0.5F, 0.1F));
    const auto shown = [&](const char* name) {
        return toneMapped(image, toneMapFromText(name), 0.5F).pixels[0];
    };
    const glm::vec3 exposed = 0.5F * image.pixels[0];
    EXPECT_EQ(shown("neutral"), shared::neutralToneMapped(exposed));
    EXPECT_EQ(shown("agx"), shared::agxToneMapped(exposed));
    EXPECT_EQ(shown("aces"), shared::acesToneMapped(exposed));
    EXPECT_EQ(shown("none"), exposed);
}

TEST(NeutralToneMap, ShowsNoNumberAsBlack) {
    Image image(3, 1, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    image.pixels[1] = glm::vec3(-1.0F);
    image.pixels[2] = glm::vec3(std::numeric_limits<float>::infinity());
    image = toneMapped(image, ToneMap::neutral, 1.0F);
    EXPECT_EQ(image.pixels[0], glm::vec3(0.0F));
    EXPECT_EQ(image.pixels[1], glm::vec3(0.0F));
    EXPECT_NEAR(image.pixels[2].r, 1.0F, 1e-3F);
    expectMentions(errorOf([] { toneMapFromText("filmic"); }), {"filmic", "neutral", "agx", "aces", "none"});
}

TEST(AutomaticExposure, BringsAPictureToMiddleGrey) {
    const Image grey(8, 8, glm::vec3(0.5F));
    EXPECT_NEAR(automaticExposure(grey), 0.36F, 0.001F);
    EXPECT_NEAR(toneMapped(grey, ToneMap::none, 0.36F).pixels[0].g, 0.18F, 1e-6F);
    EXPECT_NEAR(automaticExposure(Image(8, 8, glm::vec3(2049.0F))), 8.8e-5F, 0.01e-5F);
    EXPECT_EQ(automaticExposure(Image(8, 8)), 1.0F);
    EXPECT_EQ(automaticExposure(Image(0, 0)), 1.0F);
}

TEST(AutomaticExposure, IsChangedLittleByASmallEmitterAndNotByBlack) {
    Image image(32, 32, glm::vec3(0.1F));
    const float without = automaticExposure(image);
    for (int i = 0; i < 5; ++i)
        image.pixels[static_cast<std::size_t>(i)] = glm::vec3(1e5F);
    EXPECT_NEAR(automaticExposure(image) / without, 1.0F, 0.1F);
    Image half(32, 32, glm::vec3(0.1F));
    for (int i = 0; i < 512; ++i)
        half.pixels[static_cast<std::size_t>(i)] = glm::vec3(i % 2 == 0 ? 0.0F : 1e-6F);
    EXPECT_EQ(automaticExposure(half), without);
}

}  // namespace
}  // namespace vct::test
