#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "image/compare.h"
#include "support/errors.h"

namespace vct {
namespace {

float step(int n) {
    return float(n) / 255.0F;
}

TEST(CompareImages, ADifferenceOfExactlyTheLimitIsNone) {
    for (int n = 0; n < 250; ++n) {
        const Image a(1, 1, glm::vec3(step(n)));
        EXPECT_EQ(compareImages(a, Image(1, 1, glm::vec3(step(n + 5))), step(5)).fraction, 0.0) << n;
        EXPECT_EQ(compareImages(a, Image(1, 1, glm::vec3(step(n + 6))), step(5)).fraction, 1.0) << n;
    }
}

TEST(CompareImages, ALimitOfZeroSeesTheLastBit) {
    const Image a(1, 1, glm::vec3(1000.0F));
    const Image b(1, 1, glm::vec3(std::nextafter(1000.0F, 2000.0F)));
    EXPECT_EQ(compareImages(a, b, 0.0F).fraction, 1.0);
}

TEST(CompareImages, SizesMustAgree) {
    const Difference difference = compareImages(Image(4, 2), Image(2, 4), 1.0F);
    EXPECT_FALSE(difference.comparable);
    test::expectMentions(difference.reason, {"4 x 2"});
    test::expectMentions(difference.reason, {"2 x 4"});
    EXPECT_FALSE(compareImages(Image(), Image(), 1.0F).comparable);
}

TEST(CompareImages, EveryValueMustBeFiniteEvenWhereBothAreNot) {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {std::nanf(""), infinity, -infinity}) {
        for (int channel = 0; channel < 3; ++channel) {
            const Image good(5, 4);
            Image wrong = good;
            wrong.at(3, 2)[channel] = bad;
            const Difference second = compareImages(good, wrong, 1.0F);
            EXPECT_FALSE(second.comparable);
            test::expectMentions(second.reason, {"second picture"});
            test::expectMentions(second.reason, {"(3, 2)"});
            test::expectMentions(compareImages(wrong, good, 1.0F).reason, {"first picture"});
            EXPECT_FALSE(compareImages(wrong, wrong, 1.0F).comparable);
        }
    }
}

TEST(DifferenceImage, ShowsTheLimitAsMidGrey) {
    Image a(4, 1);
    Image b(4, 1);
    b.at(1, 0) = glm::vec3(0.2F);
    b.at(2, 0) = {0.0F, -9.0F, 0.1F};
    a.at(3, 0).x = std::nanf("");
    const Image difference = differenceImage(a, b, 0.2F);
    EXPECT_EQ(difference.at(0, 0), glm::vec3(0.0F));
    EXPECT_NEAR(srgbEncode(difference.at(1, 0).g), 0.5F, 1e-4F);
    EXPECT_EQ(difference.at(2, 0).g, 1.0F);
    EXPECT_NEAR(srgbEncode(difference.at(2, 0).b), 0.25F, 1e-4F);
    EXPECT_EQ(difference.at(3, 0), glm::vec3(1.0F, 0.0F, 1.0F));
    EXPECT_EQ(differenceImage(a, b, 0.0F).at(1, 0), glm::vec3(1.0F));
    EXPECT_EQ(differenceImage(a, b, 0.0F).at(0, 0), glm::vec3(0.0F));
    EXPECT_THROW(differenceImage(a, Image(1, 4), 0.2F), Error);
}

}  // namespace
}  // namespace vct
