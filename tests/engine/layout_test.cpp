// Bit layouts: exact, and the same on both sides because they are written once.
#include <gtest/gtest.h>

#include <cstddef>
#include <random>

#include "shared/layout.h"

using namespace vct::shared;

TEST(VoxelWord, RoundTripsEveryField) {
    std::mt19937 random(1);
    for (int i = 0; i < 10000; ++i) {
        const uint light = random() % 16, count = random() % 16;
        const uvec3 color(random() % 256, random() % 256, random() % 256);
        const uint word = packVoxel(light, count, color);
        ASSERT_EQ(voxelLight(word), light);
        ASSERT_EQ(voxelCount(word), count);
        ASSERT_EQ(voxelColor(word), color);
    }
}

TEST(VoxelWord, HasTheThesissOrder) {  // figure 4.3
    EXPECT_EQ(packVoxel(8, 8, uvec3(0x12, 0x34, 0x56)), 0x88123456U);
    // Lit wins over unlit under imageAtomicMax, whatever the colour.
    EXPECT_GT(packVoxel(8, 8, uvec3(0)), packVoxel(0, 8, uvec3(255)));
}

TEST(VoxelWord, EightChildrenNeverOverflowAField) {
    const uint brightest = packVoxel(8, 8, uvec3(248));
    uint parent = 0;
    for (int i = 0; i < 8; ++i)
        parent += childContribution(brightest);
    EXPECT_EQ(parent, packVoxel(8, 8, uvec3(248)));
}

TEST(VoxelWord, LightOfAChildByEquation45) {
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

TEST(UniformBlocks, FollowStd140) {
    // Three matrices, four vectors, and twelve scalars (two of them a vec2): sixteen-byte steps, as std140
    // lays them out.
    EXPECT_EQ(sizeof(FrameUniforms), 3 * 64 + 7 * 16U);
    EXPECT_EQ(offsetof(FrameUniforms, shadowConeRadius), 256U);
    EXPECT_EQ(offsetof(FrameUniforms, gridSide), 284U);
    EXPECT_EQ(offsetof(FrameUniforms, eye), 192U);
    EXPECT_EQ(sizeof(DrawUniforms), 2 * 64 + 3 * 16U);
    // std430: tightly packed.
    EXPECT_EQ(sizeof(LevelCommands), 64U);
    EXPECT_EQ(offsetof(LevelCommands, faceGroupsX), 24U);
    EXPECT_EQ(sizeof(CommandLists), VCT_LISTS * sizeof(LevelCommands) + 16U);
    EXPECT_EQ(sizeof(LightStep) % 16, 0U);
    EXPECT_EQ(sizeof(FaceRange), 16U);
    EXPECT_EQ(offsetof(LevelCommands, groupsX), 4U);
}
