// The schedule of light steps from a change to convergence, without GL.
#include <gtest/gtest.h>

#include "engine/directional/light_schedule.h"

namespace vct::test {
namespace {

constexpr LightSchedule::Change noChange, otherLight{.light = true}, otherPose{.lists = true, .light = true},
    otherPlace{.lists = true, .voxelized = 1, .cascades = true};

GatherSettings settingsWith(int directions, int refined, int rays) {
    GatherSettings settings;
    settings.directions = directions;
    settings.refinedDirections = refined;
    settings.rays = rays;
    return settings;
}

TEST(LightSchedule, SettlesThenRefinesThenStops) {
    LightSchedule schedule(settingsWith(64, 256, 8), 16);
    EXPECT_EQ(schedule.convergenceSteps(), 16 + 32);
    for (int i = 0; i < schedule.convergenceSteps(); ++i) {
        EXPECT_FALSE(schedule.isConverged()) << i;
        const LightPlan plan = schedule.advance(noChange);
        EXPECT_EQ(plan.step, static_cast<std::uint32_t>(i));
        EXPECT_EQ(plan.traces, i < 8) << i;
        EXPECT_EQ(plan.updatesDirect, i == 0) << i;
        EXPECT_EQ(plan.refiningStep, i < 16 ? -1 : i - 16) << i;
        EXPECT_EQ(plan.endsRefinement(), i == 47) << i;
        EXPECT_FALSE(plan.interrupts) << i;
    }
    EXPECT_TRUE(schedule.isConverged());
}

TEST(LightSchedule, AQuickPictureIsNotRefined) {
    EXPECT_EQ(LightSchedule(settingsWith(64, 1024, 8), 8).convergenceSteps(), 8);
}

TEST(LightSchedule, OtherLightTracesNoRayAndInterruptsARefinement) {
    LightSchedule schedule(settingsWith(64, 256, 8), 16);
    for (int i = 0; i < 20; ++i)
        schedule.advance(noChange);
    const LightPlan plan = schedule.advance(otherLight);
    EXPECT_TRUE(plan.interrupts);
    EXPECT_TRUE(plan.updatesDirect);
    EXPECT_FALSE(plan.traces);
    EXPECT_EQ(plan.refiningStep, -1);
    // The next change finds no refinement.
    EXPECT_FALSE(schedule.advance(otherLight).interrupts);
    for (int i = 0; i < 47; ++i) {
        EXPECT_FALSE(schedule.isConverged()) << i;
        schedule.advance(noChange);
    }
    EXPECT_TRUE(schedule.isConverged());
}

TEST(LightSchedule, OtherPosesTraceWithinABudgetAndThenTheRest) {
    LightSchedule schedule(settingsWith(64, 256, 8), 16);
    while (!schedule.isConverged())
        schedule.advance(noChange);
    const LightPlan moving = schedule.advance(otherPose);
    EXPECT_TRUE(moving.traces);
    EXPECT_GT(moving.movingRays, 0U);
    EXPECT_EQ(moving.minMovingRays, 1U);
    // At rest each ray of the moving objects is traced once more.
    int rays = 0;
    for (LightPlan plan = schedule.advance(noChange); plan.traces; plan = schedule.advance(noChange))
        rays += static_cast<int>(plan.minMovingRays);
    EXPECT_GE(rays + 8, 64);
}

TEST(LightSchedule, AMoveOfCascadesVisitsWhatItHasChanged) {
    LightSchedule schedule(settingsWith(64, 256, 8), 16);
    while (!schedule.isConverged())
        EXPECT_TRUE(schedule.advance(noChange).visitsAll);
    std::uint32_t rays = 0;
    for (int i = 0; i < 65; ++i) {
        const LightPlan plan = schedule.advance(i == 0 ? otherPlace : noChange);
        EXPECT_FALSE(plan.visitsAll) << i;
        // New faces find the light of emitters in turns.
        EXPECT_FALSE(plan.updatesEmitters) << i;
        EXPECT_EQ(plan.emitterTurns, i > 0 && i <= LightSchedule::emitterTurns ? 16U : 1U) << i;
        EXPECT_EQ(plan.gathers, i > 0) << i;
        // The refinement visits all that no refinement has visited.
        EXPECT_EQ(plan.listsVisited, i == 0 || i == 33) << i;
        if (plan.listsVisited) {
            EXPECT_EQ(plan.visitsSince, i == 0 ? 17U : 1U);
        }
        if (plan.gathers && plan.traces) rays += plan.rays;
    }
    EXPECT_GE(rays, 64U);
    EXPECT_TRUE(schedule.isConverged());
}

TEST(LightSchedule, MovesInEachFrameGatherInEachSecondStep) {
    LightSchedule schedule(settingsWith(64, 256, 8), 16);
    while (!schedule.isConverged())
        schedule.advance(noChange);
    for (int i = 0; i < 8; ++i)
        EXPECT_EQ(schedule.advance(otherPlace).gathers, i % 2 == 1) << i;
}

TEST(LightSchedule, AMoveAfterOtherLightVisitsAllUntilTheBouncesAreIn) {
    LightSchedule schedule(settingsWith(64, 256, 8), 16);
    while (!schedule.isConverged())
        schedule.advance(noChange);
    EXPECT_TRUE(schedule.advance(otherLight).visitsAll);
    for (int i = 1; i < 16; ++i)
        EXPECT_TRUE(schedule.advance(i == 5 ? otherPlace : noChange).visitsAll) << i;
    const LightPlan later = schedule.advance(noChange);
    EXPECT_FALSE(later.visitsAll);
    EXPECT_TRUE(later.listsVisited);
    // No refinement has visited the other faces since their light changed.
    LightPlan plan = later;
    while (plan.refiningStep < 0)
        plan = schedule.advance(noChange);
    EXPECT_TRUE(plan.visitsAll);
}

}  // namespace
}  // namespace vct::test
