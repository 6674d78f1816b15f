#include <gtest/gtest.h>

#include "core/error.h"
#include "image/image.h"

namespace vct {
namespace {

const glm::vec3 red(0.8F, 0.1F, 0.1F);
const glm::vec3 blue(0.1F, 0.1F, 0.8F);
const glm::vec3 paper(1.0F);

int darkPixels(const Image& sheet, int left, int top, int right, int bottom) {
    int count = 0;
    for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x)
            count += sheet.at(x, y).g < 0.05F ? 1 : 0;
    }
    return count;
}

TEST(ContactSheet, PlacesPicturesInReadingOrderWithGaps) {
    const Image a(100, 60, red);
    const Image b(100, 60, blue);
    const Image sheet = contactSheet({{"one", a}, {"two", b}, {"three", b}}, 2);
    // 8 pixels are around and between pictures, 4 and 24 below for the label.
    ASSERT_EQ(sheet.width, 8 + 2 * 108);
    ASSERT_EQ(sheet.height, 8 + 2 * (60 + 28 + 8));
    EXPECT_EQ(sheet.at(7, 7), paper);
    EXPECT_EQ(sheet.at(8, 8), red);
    EXPECT_EQ(sheet.at(107, 67), red);
    EXPECT_EQ(sheet.at(108, 67), paper);
    EXPECT_EQ(sheet.at(116, 8), blue);
    EXPECT_EQ(sheet.at(8, 104), blue);
    EXPECT_EQ(sheet.at(116, 104), paper);  // no fourth picture
}

TEST(ContactSheet, WritesEachLabelBelowItsPicture) {
    const Image white(200, 60, paper);
    const Image sheet = contactSheet({{"mode 4: gi", white}, {"", white}}, 2);
    EXPECT_GT(darkPixels(sheet, 8, 68, 208, 100), 100);
    EXPECT_EQ(darkPixels(sheet, 0, 0, sheet.width, 68), 0);
    EXPECT_EQ(darkPixels(sheet, 210, 0, sheet.width, sheet.height), 0);
    const Image other = contactSheet({{"mode 5: ao", white}, {"", white}}, 2);
    EXPECT_NE(sheet.pixels, other.pixels);
}

TEST(ContactSheet, RefusesNothing) {
    EXPECT_THROW(contactSheet({}, 3), Error);
    EXPECT_THROW(contactSheet({{"a", Image(2, 2)}}, 0), Error);
}

}  // namespace
}  // namespace vct
