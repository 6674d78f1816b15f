// Bit layouts that C++ and the shaders share.
#include <gtest/gtest.h>

#include "shared/layout.h"

using namespace vct::shared;

TEST(VoxelWord, HasTheThesissOrder) {  // figure 4.3
    EXPECT_EQ(packVoxel(8, 8, uvec3(0x12, 0x34, 0x56)), 0x88123456U);
    // imageAtomicMax keeps a lit word of any colour.
    EXPECT_GT(packVoxel(8, 8, uvec3(0)), packVoxel(0, 8, uvec3(255)));
}

TEST(VoxelWord, EightChildrenNeverOverflowAField) {
    const uint brightest = packVoxel(8, 8, uvec3(248));
    uint parent = 0;
    for (int i = 0; i < 8; ++i)
        parent += childContribution(brightest);
    EXPECT_EQ(parent, packVoxel(8, 8, uvec3(248)));
}

TEST(VoxelWord, AChildAddsItsLightByEquation45) {
    for (uint count = 1; count <= 8; ++count)
        for (uint light = 0; light <= count; ++light) {
            const uint child = childContribution(packVoxel(light, count, uvec3(0)));
            EXPECT_EQ(voxelLight(child), light > count / 2 ? 1U : 0U) << light << " of " << count;
            EXPECT_EQ(voxelCount(child), 1U);
        }
}

TEST(ListEntry, RoundTripsEveryCoordinateOf512) {
    for (uint i = 0; i < 512; ++i) {
        EXPECT_EQ(unpackEntry(packEntry(uvec3(i, 511 - i, i ^ 5U))), uvec3(i, 511 - i, i ^ 5U));
    }
}
