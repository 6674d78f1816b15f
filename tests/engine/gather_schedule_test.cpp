// The schedule of gather steps from a change to convergence, without GL.
#include <gtest/gtest.h>

#include <set>

#include "engine/directional/gather_schedule.h"

namespace vct::test {
namespace {

constexpr GatherSchedule::Change noChange, otherLight{.light = true};

GatherSettings settingsWith(int directions, int refined, int rays) {
    GatherSettings settings;
    settings.directions = directions;
    settings.refinedDirections = refined;
    settings.rays = rays;
    return settings;
}

TEST(GatherSchedule, SettlesThenRefinesThenStops) {
    GatherSchedule schedule(settingsWith(64, 256, 8), 16);
    EXPECT_EQ(schedule.convergenceSteps(), 16 + 32);
    for (int i = 0; i < schedule.convergenceSteps(); ++i) {
        EXPECT_FALSE(schedule.isConverged()) << i;
        const GatherStep step = schedule.advance(noChange);
        EXPECT_EQ(step.frame, static_cast<std::uint32_t>(i));
        EXPECT_EQ(step.rays, 8U);
        EXPECT_EQ(step.roundShare, i < 8 ? 0.0F : i < 16 ? 1.0F / 8.0F : 1.0F / 32.0F) << i;
        EXPECT_EQ(step.beginsRound, i == 8 || i == 16) << i;
        EXPECT_EQ(step.minHistory > 0.0F, i == 47) << i;
    }
    EXPECT_TRUE(schedule.isConverged());
}

TEST(GatherSchedule, RefinementVisitsEachDirectionOnce) {
    GatherSchedule schedule(settingsWith(64, 256, 8), 16);
    std::set<std::uint32_t> visited;
    for (int i = 0; i < 48; ++i) {
        const GatherStep step = schedule.advance(noChange);
        for (std::uint32_t ray = 0; i >= 16 && ray < step.rays; ++ray)
            visited.insert((step.direction + ray) % 256);
    }
    EXPECT_EQ(visited.size(), 256U);
}

// A light that moves would lag behind with the long history of converged light.
TEST(GatherSchedule, AChangeShortensHistories) {
    GatherSchedule schedule(settingsWith(64, 256, 8), 16);
    while (!schedule.isConverged())
        schedule.advance(noChange);
    const float during = schedule.advance(otherLight).history;
    EXPECT_LE(during, 15.0F);
    EXPECT_LT(schedule.advance(noChange).history, during);
}

}  // namespace
}  // namespace vct::test
