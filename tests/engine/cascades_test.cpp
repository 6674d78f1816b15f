// Places of the nested cubes of voxels.
#include "engine/cascades.h"

#include <gtest/gtest.h>

namespace vct {
namespace {

TEST(Cascades, HalveAndSurroundTheEye) {
    Cascades cascades(4, 64);
    const glm::dvec3 eye(0.3, 0.11, 0.77);
    cascades.follow(eye);
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(cascades.side(i), 0.125 * (1 << i));
        for (int axis = 0; axis < 3; ++axis) {
            const double corner = cascades.corner(i)[axis], side = cascades.side(i);
            EXPECT_GE(corner, 0.0);
            EXPECT_LE(corner + side, 1.0);
            // In the middle up to half a step, unless the border of the volume is in the way.
            if (corner > 0.0 && corner + side < 1.0) {
                EXPECT_NEAR(eye[axis], corner + 0.5 * side, side / 16.0);
            }
        }
    }
}

TEST(Cascades, LieOnTheirBricksSoThatVoxelsStayInPlace) {
    Cascades cascades(5, 64);
    for (int frame = 0; frame < 200; ++frame) {
        cascades.follow(glm::dvec3(0.1 + 0.004 * frame, 0.2, 0.5));
        for (int i = 0; i < 5; ++i) {
            const glm::dvec3 bricks = cascades.corner(i) * (8.0 / cascades.side(i));
            EXPECT_EQ(bricks, glm::round(bricks)) << "cascade " << i;
        }
    }
}

TEST(Cascades, DoNotMoveBackAndForthAtTheBorderOfTwoSteps) {
    Cascades cascades(3, 64);
    const double step = cascades.side(0) / 8.0;
    cascades.follow(glm::dvec3(0.5));
    EXPECT_TRUE(cascades.follow(glm::dvec3(0.5 + 0.76 * step, 0.5, 0.5)));
    for (int frame = 0; frame < 10; ++frame)
        EXPECT_FALSE(cascades.follow(glm::dvec3(0.5 + (frame % 2 == 0 ? 0.4 : 0.6) * step, 0.5, 0.5)));
}

TEST(Cascades, OneIsTheVolumeWhereverTheEyeIs) {
    Cascades cascades(1, 64);
    EXPECT_FALSE(cascades.follow(glm::dvec3(0.9)));
    EXPECT_EQ(cascades.side(0), 1.0);
    EXPECT_EQ(cascades.corner(0), glm::dvec3(0.0));
}

}  // namespace
}  // namespace vct
