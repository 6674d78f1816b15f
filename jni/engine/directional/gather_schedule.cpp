#include "engine/directional/gather_schedule.h"

#include <algorithm>

#include "shared/layout.h"

namespace vct {

namespace {

// Maximum history length in steps while light or surfaces change. A shorter history is noisy, a longer one
// lags behind the change (docs/design-decisions.md).
constexpr float maxHistoryWhileChanging = 15.0F;
// The same in the first step after the changes. Steps have more rays then, so outdated light can be replaced
// sooner.
constexpr float maxHistoryAfterChange = 9.0F;
// Minimum number of rays in the first step of a face without a history.
constexpr std::uint32_t initialRays = 8;
// Maximum history length in steps. A few more rays hardly change such a long mean.
constexpr float maxHistory = 192.0F;
// Decrease of the block's weight in a face's irradiance per step after the changes.
constexpr float smoothingDecay = 0.25F;

// Steps after cascades have moved in which only the faces that are new to their cascade gather, with a budget
// of rays, so that a walk costs the same in every frame. The light of all others has not changed.
constexpr int stepsAfterMove = 24;
// Faces with a history of this length are no longer new to their cascade: 128 rays.
constexpr float longEnoughAfterMove = 24.0F;
// Rays per turn of a face.
constexpr std::uint32_t raysAfterMove = 8;
// The step in which cascades move has a smaller budget, because its frame also voxelizes.
constexpr std::uint32_t movingBudgetDivisor = 4;

}  // namespace

GatherSchedule::GatherSchedule(const GatherSettings& settings, int lightFrames)
    : rays_(settings.rays),
      rayBudget_(settings.rayBudget),
      lightFrames_(lightFrames),
      convergenceRound_(settings.directions / settings.rays),
      refinementSteps_(lightFrames >= 2 * convergenceRound_ ? settings.refinedDirections / settings.rays
                                                            : 0) {
    invalidate();
}

void GatherSchedule::invalidate() {
    history_ = 0.0F;
    stepsLeft_ = convergenceSteps();
    lastShare_ = 0.0F;
}

// After a change, steps without rounds come first, at least as many as a round has. Whole rounds follow, then
// the refinement, which is one long round. A step in which anything changes belongs to no round.
GatherSchedule::Round GatherSchedule::round(bool changed) const {
    if (changed) return {};
    if (stepsLeft_ <= refinementSteps_) return {refinementSteps_, refinementSteps_ - stepsLeft_};
    const int left = stepsLeft_ - refinementSteps_;
    const int rounds = std::max(lightFrames_ / convergenceRound_ - 1, 0);
    if (left > rounds * convergenceRound_) return {};
    return {convergenceRound_, (convergenceRound_ - left % convergenceRound_) % convergenceRound_};
}

GatherStep GatherSchedule::advance(const Change& change) {
    const bool onlyMoved = change.cascades && !change.light;
    const bool changed = change.any() && !onlyMoved;
    if (change.light) {
        history_ = std::min(history_, maxHistoryWhileChanging);
        stepsLeft_ = convergenceSteps();
    }
    if (!changed && !lastStepUnchanged_) history_ = std::min(history_, maxHistoryAfterChange);
    if (change.cascades) {
        stepsLeft_ = convergenceSteps();
        movedStepsLeft_ = stepsAfterMove;
    }
    const bool moved = !changed && movedStepsLeft_ > 0;
    const bool hasBudget = changed || moved;
    movedStepsLeft_ = std::max(movedStepsLeft_ - 1, 0);
    smoothing_ = changed ? 1.0F : std::max(smoothing_ - smoothingDecay, 0.0F);
    lastStepUnchanged_ = !changed;

    const Round inRound = round(hasBudget);
    const float share = inRound.length > 0 ? 1.0F / static_cast<float>(inRound.length)
                                           : recentStepWeight / (history_ + recentStepWeight);
    GatherStep step;
    step.frame = frame_;
    step.direction = direction_;
    step.rays = hasBudget ? 1U : static_cast<std::uint32_t>(rays_);
    step.rayBudget = hasBudget ? static_cast<std::uint32_t>(rayBudget_) : 0U;
    step.initialRays = std::max(initialRays, step.rays);
    if (moved) {
        step.rays = raysAfterMove;
        step.rayBudget /= raysAfterMove;  // of faces, in this case
        if (change.cascades) step.rayBudget /= movingBudgetDivisor;
        step.longEnough = longEnoughAfterMove;
    }
    step.beginsRound = inRound.length > 0 && inRound.place == 0;
    step.roundShare = inRound.length > 0 ? share : 0.0F;
    step.history = history_;
    step.minHistory = stepsLeft_ <= 1 ? maxHistory : 0.0F;
    // The sums of a step in which a few faces gather say nothing about the balance of all.
    step.previousStepWeight = moved ? 0.0F : lastShare_;
    step.energyCorrection = inRound.length > 0 ? lastShare_ : std::max(lastShare_, 0.5F);
    step.smoothing = smoothing_;

    lastShare_ = moved ? 0.0F : share;
    history_ = history_ == 0.0F ? float{VCT_INITIAL_HISTORY} : std::min(history_ + 1.0F, maxHistory);
    if (!hasBudget) direction_ += static_cast<std::uint32_t>(rays_);
    ++frame_;
    if (!hasBudget || changed) stepsLeft_ = std::max(stepsLeft_ - 1, 0);
    // If only the lists change after convergence, a few rays should change the light little.
    if (stepsLeft_ == 0) history_ = maxHistory;
    return step;
}

}  // namespace vct
