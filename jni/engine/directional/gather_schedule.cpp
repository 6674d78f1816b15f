#include "engine/directional/gather_schedule.h"

#include <algorithm>

#include "shared/layout.h"

namespace vct {

namespace {

// Once light or surfaces have changed, the history is wrong but near. So many steps of it are kept: fewer
// would be noise, more would lag behind (docs/levers.md).
constexpr float maxHistoryWhileChanging = 15.0F;
// When the changes have ended there are more cones in each step, and what lagged behind is forgotten sooner.
constexpr float maxHistoryAfterChange = 9.0F;
// A face without a history traces at least so many cones in its first step.
constexpr std::uint32_t initialCones = 8;
// The longest history, in steps: what a few cones add to it then is hardly seen.
constexpr float maxHistory = 192.0F;
// Once the changes have ended, so much less of a face's light is its block's in each step.
constexpr float smoothingDecay = 0.25F;

}  // namespace

GatherSchedule::GatherSchedule(const GatherSettings& settings, int lightFrames)
    : cones_(settings.cones),
      coneBudget_(settings.coneBudget),
      lightFrames_(lightFrames),
      settlingRound_(settings.directions / settings.cones),
      refinementSteps_(lightFrames >= 2 * settlingRound_ ? settings.refinedDirections / settings.cones : 0) {
    invalidate();
}

void GatherSchedule::invalidate() {
    history_ = 0.0F;
    stepsLeft_ = convergenceSteps();
    lastShare_ = 0.0F;
}

// While the light settles, the last steps are whole rounds; those before them, at least as many as a round
// has, are not. Refinement is one long round. Where only lists change, rounds go on.
GatherSchedule::Round GatherSchedule::round(bool changed) const {
    if (changed) return {};
    if (stepsLeft_ <= refinementSteps_) return {refinementSteps_, refinementSteps_ - stepsLeft_};
    const int left = stepsLeft_ - refinementSteps_;
    const int rounds = std::max(lightFrames_ / settlingRound_ - 1, 0);
    if (left > rounds * settlingRound_) return {};
    return {settlingRound_, (settlingRound_ - left % settlingRound_) % settlingRound_};
}

GatherStep GatherSchedule::advance(const Change& change) {
    const bool changed = change.any();
    if (change.light) {
        history_ = std::min(history_, maxHistoryWhileChanging);
        stepsLeft_ = convergenceSteps();
    }
    if (!changed && !isSettling_) history_ = std::min(history_, maxHistoryAfterChange);
    smoothing_ = changed ? 1.0F : std::max(smoothing_ - smoothingDecay, 0.0F);
    isSettling_ = !changed;

    const Round inRound = round(changed);
    const float share = inRound.length > 0 ? 1.0F / static_cast<float>(inRound.length)
                                           : recentStepWeight / (history_ + recentStepWeight);
    GatherStep step;
    step.frame = frame_;
    step.direction = direction_;
    step.cones = changed ? 1U : static_cast<std::uint32_t>(cones_);
    step.coneBudget = changed ? static_cast<std::uint32_t>(coneBudget_) : 0U;
    step.initialCones = std::max(initialCones, step.cones);
    step.beginsRound = inRound.length > 0 && inRound.place == 0;
    step.roundShare = inRound.length > 0 ? share : 0.0F;
    step.history = history_;
    step.minHistory = stepsLeft_ <= 1 ? maxHistory : 0.0F;
    step.amplitude = lastShare_;
    step.energyCorrection = inRound.length > 0 ? lastShare_ : std::max(lastShare_, 0.5F);
    step.smoothing = smoothing_;

    lastShare_ = share;
    history_ = history_ == 0.0F ? float{VCT_INITIAL_HISTORY} : std::min(history_ + 1.0F, maxHistory);
    if (!changed) direction_ += static_cast<std::uint32_t>(cones_);
    ++frame_;
    stepsLeft_ = std::max(stepsLeft_ - 1, 0);
    // A few cones in rebuilt voxels change converged light little.
    if (stepsLeft_ == 0) history_ = maxHistory;
    return step;
}

}  // namespace vct
