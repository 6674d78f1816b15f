// Decides how each light step gathers: how many cones, how long the histories are, and when the light has
// converged. It knows nothing of GL.
#pragma once

#include <cstdint>

#include "engine/settings.h"

namespace vct {

// The way in which one light step gathers (shaders/shared/layout.h: LightStep).
struct GatherStep {
    std::uint32_t frame = 0;         // number of the step
    std::uint32_t direction = 0;     // the first of the set of directions that a step without a budget visits
    std::uint32_t cones = 0;         // per face
    std::uint32_t initialCones = 0;  // per face without a history
    std::uint32_t coneBudget = 0;    // cones of the whole step, for which faces take turns; 0: no limit
    bool beginsRound = false;        // the step is the first of a round, which visits each direction once
    float roundShare = 0.0F;         // of the step in its round; 0 outside of rounds
    float history = 0.0F;            // longest history of a face, in steps
    float minHistory = 0.0F;         // shortest history after the step: long where the light has converged
    float amplitude = 0.0F;          // share that the step before had in the means
    float energyCorrection = 0.0F;   // share of the way to the balance of all light that the step makes good
    float smoothing = 0.0F;          // how much of a face's light may be its block's, 0..1
};

class GatherSchedule {
  public:
    // `lightFrames`: steps after a change until the light has settled. If they hold at least two rounds and
    // the settings ask for more directions, refinement follows.
    GatherSchedule(const GatherSettings& settings, int lightFrames);

    // A change of the voxels since the last step.
    struct Change {
        bool lists = false;  // the dynamic objects were voxelized in a new pose
        bool light = false;  // what faces send, or what is in the way of it, has changed
        bool any() const { return lists || light; }
    };
    // Begins the next step.
    GatherStep advance(const Change& change);
    // The next steps begin as the first ones did.
    void invalidate();

    // Steps after a change until the light has converged, refinement included.
    int convergenceSteps() const { return lightFrames_ + refinementSteps_; }
    // Says whether another step without a change would change nothing.
    bool isConverged() const { return stepsLeft_ == 0; }

  private:
    // The length of the round that the next step belongs to, and its place there; a length of 0 outside of
    // rounds.
    struct Round {
        int length = 0, place = 0;
    };
    Round round(bool changed) const;

    int cones_, coneBudget_, lightFrames_, settlingRound_, refinementSteps_;
    int stepsLeft_ = 0;
    bool isSettling_ = true;  // nothing had changed before the last step
    float history_ = 0.0F;    // of the means, in steps
    float lastShare_ = 0.0F;  // of the last step in them
    float smoothing_ = 0.0F;
    std::uint32_t frame_ = 0, direction_ = 0;
};

}  // namespace vct
