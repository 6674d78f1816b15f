// DrawRegion: no instance that a pass would show is skipped.
#include "engine/draw_region.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace vct {
namespace {

bool isInside(const glm::dmat4& regionFromVolume, const glm::dvec3& point) {
    const glm::dvec4 p = regionFromVolume * glm::dvec4(point, 1.0);
    for (int axis = 0; axis < 3; ++axis)
        if (p[axis] < 0.0 || p[axis] > p.w) return false;
    return true;
}

// A box of random size around a random place, up to twice as far as the volume.
Bounds randomBox(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-1.0, 2.0), size(0.0, 0.3);
    const glm::dvec3 corner(place(random), place(random), place(random));
    return {corner, corner + glm::dvec3(size(random), size(random), size(random))};
}

// Checks many boxes: one with a point inside meets the region, and most of the others do not.
void expectToSkipOnlyUnseenBoxes(const DrawRegion& region, const glm::dmat4& regionFromVolume) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> within(0.0, 1.0);
    int unseen = 0, skipped = 0;
    for (int i = 0; i < 2000; ++i) {
        const Bounds box = randomBox(random);
        bool isSeen = false;
        for (int k = 0; k < 500 && !isSeen; ++k)
            isSeen = isInside(
                regionFromVolume,
                glm::mix(box.min, box.max, glm::dvec3(within(random), within(random), within(random))));
        const bool meets = region.meets(box);
        EXPECT_TRUE(meets || !isSeen);
        unseen += isSeen ? 0 : 1;
        skipped += meets ? 0 : 1;
    }
    EXPECT_GT(skipped, 0.9 * unseen);
}

TEST(DrawRegion, HoldsEveryBoxThatACameraSees) {
    const glm::dmat4 clipFromVolume = glm::perspective(1.0, 1.5, 0.01, 2.0) *
                                      glm::lookAt(glm::dvec3(0.2, 0.3, 0.9), glm::dvec3(0.5), {0, 1, 0});
    const glm::dmat4 toUnit = glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(0.5)), glm::dvec3(0.5));
    expectToSkipOnlyUnseenBoxes(DrawRegion::inClipSpace(clipFromVolume), toUnit * clipFromVolume);
}

TEST(DrawRegion, HoldsEveryBoxInACube) {
    const glm::dvec3 corner(0.25, 0.5, 0.125);
    const glm::dmat4 cubeFromVolume =
        glm::scale(glm::dmat4(1.0), glm::dvec3(4.0)) * glm::translate(glm::dmat4(1.0), -corner);
    expectToSkipOnlyUnseenBoxes(DrawRegion::cube(corner, 0.25), cubeFromVolume);
}

// A surface without thickness on the region's border is drawn, whatever the shaders' rounding.
TEST(DrawRegion, HoldsASheetOnItsBorder) {
    const DrawRegion region = DrawRegion::cube(glm::dvec3(0.25), 0.5);
    for (const double x : {0.25, 0.75})
        EXPECT_TRUE(region.meets({{x, 0.3, 0.3}, {x, 0.4, 0.4}})) << x;
    EXPECT_TRUE(region.meets({{0.25 - 1e-6, 0.3, 0.3}, {0.25 - 1e-6, 0.4, 0.4}}));
    EXPECT_FALSE(region.meets({{0.24, 0.3, 0.3}, {0.24, 0.4, 0.4}}));
}

}  // namespace
}  // namespace vct
