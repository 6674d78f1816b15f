#include "engine/directional/light_schedule.h"

#include <algorithm>

namespace vct {

namespace {

// With fewer steps for the bounces, the caller asks for a quick picture.
constexpr int minFramesToRefine = 16;

// With fewer steps, each visits all cascades.
constexpr int minFramesForTurns = 8;

constexpr int movePace = VCT_MOVE_PACE;

// The first steps add more bounces, so that the first picture is as bright as the later ones.
constexpr std::uint32_t firstSteps = 2;
constexpr int firstBounces = 4;

}  // namespace

LightSchedule::LightSchedule(const GatherSettings& settings, int lightFrames, int cascades)
    : lightFrames_(lightFrames),
      cascades_(cascades),
      refiningSteps_(lightFrames >= minFramesToRefine ? settings.refinedDirections / settings.rays : 0),
      tracingSteps_((settings.directions + settings.rays - 1) / settings.rays),
      rayBudget_(settings.rayBudget),
      rays_(settings.rays),
      moveSteps_(std::max(lightFrames, movePace * tracingSteps_ + 1)),
      stepsLeft_(convergenceSteps()),
      tracingStepsLeft_(tracingSteps_) {}

LightPlan LightSchedule::advance(const Change& change) {
    LightPlan plan;
    plan.step = step_++;
    const bool isFirst = plan.step == 0;
    plan.updatesDirect = change.light || change.lists || isFirst;
    const bool spreadsEmitters = change.isMove() && !isFirst;
    if (spreadsEmitters) emitterStepsLeft_ = emitterTurns;
    plan.updatesEmitters = !spreadsEmitters && (change.emitters || change.lists || isFirst);
    if (plan.updatesEmitters) emitterStepsLeft_ = 0;
    plan.updatesSky = change.sky;
    plan.refiningSteps = refiningSteps_;
    // This step traces some rays of moving objects, and those after it trace each of them once.
    if (change.lists) tracingStepsLeft_ = (change.isMove() ? movePace : 1) * tracingSteps_ + 1;
    plan.traces = tracingStepsLeft_ > 0;
    plan.startsDark = startsDark_ && plan.step < static_cast<std::uint32_t>(tracingSteps_);
    plan.bounces = plan.startsDark && plan.step < firstSteps ? firstBounces : 1;
    // In a frame in which nothing moves, the hits of moving objects may still be those of earlier poses.
    plan.movingRays = change.lists ? static_cast<std::uint32_t>(rayBudget_) : 0;
    plan.minMovingRays = change.lists ? 1 : static_cast<std::uint32_t>(rays_);
    if (change.any()) {
        plan.interrupts = stepsLeft_ > 0 && stepsLeft_ < refiningSteps_;
        stepsLeft_ = (change.isMove() ? moveSteps_ : lightFrames_) + refiningSteps_;
    } else if (stepsLeft_ <= refiningSteps_) {
        plan.refiningStep = refiningSteps_ - stepsLeft_;
    }
    if (stepsLeft_ > 0) --stepsLeft_;

    const bool changesAll = isFirst || (change.any() && !change.isMove());
    if (changesAll) {
        changedAll_ = step_;
        outdated_ = (1U << static_cast<unsigned>(cascades_)) - 1;
        outdatedEmitters_ |= plan.updatesEmitters;
    }
    const auto steps = static_cast<std::uint32_t>(lightFrames_),
               moveSteps = static_cast<std::uint32_t>(moveSteps_);
    const bool isRefining = plan.refiningStep >= 0;
    plan.visitsAll = changedAll_ != 0 && (isRefining || plan.interrupts || step_ - changedAll_ < steps);
    takeTurn(plan, isFirst);
    plan.listsVisited = !plan.visitsAll && (change.isMove() || plan.refiningStep == 0 || visitedAll_ ||
                                            (plan.visitedCascades | visitedCascades_) != 0);
    plan.findsBlocked = plan.traces || plan.updatesSky || plan.listsVisited || plan.visitsAll != visitedAll_;
    plan.visitsSince = isRefining || step_ < moveSteps ? 1 : step_ - moveSteps + 1;
    visitedAll_ = plan.visitsAll;
    visitedCascades_ = plan.visitedCascades;
    // The step of a move leaves the rays of new faces to the next one, but not twice in succession.
    plan.gathers = plan.visitsAll || plan.interrupts || !change.isMove() || !gathered_;
    gathered_ = plan.gathers;
    // Steps that visit some cascades leave the rays of others to later ones.
    if (plan.gathers && plan.visitedCascades == 0 && tracingStepsLeft_ > 0) --tracingStepsLeft_;
    if (plan.gathers && emitterStepsLeft_ > 0 && !plan.updatesEmitters) {
        --emitterStepsLeft_;
        plan.emitterTurns = emitterTurns;
    }
    if (plan.endsRefinement()) changedAll_ = 0;
    return plan;
}

// Chooses the cascades that a step visits after a change.
void LightSchedule::takeTurn(LightPlan& plan, bool isFirst) {
    if (outdated_ == 0) return;
    if (cascades_ == 1 || lightFrames_ < minFramesForTurns || isFirst || plan.startsDark || plan.interrupts) {
        outdated_ = 0;
    } else {
        do
            turn_ = turn_ % (cascades_ - 1) + 1;
        while ((outdated_ & ~1U) != 0 && (outdated_ >> static_cast<unsigned>(turn_) & 1U) == 0);
        plan.visitedCascades = 1U | 1U << static_cast<unsigned>(turn_);
        plan.visitsAll = false;
        plan.updatesDirect = true;
        plan.updatesEmitters = outdatedEmitters_;
        outdated_ &= ~plan.visitedCascades;
    }
    if (outdated_ == 0) outdatedEmitters_ = false;
}

}  // namespace vct
