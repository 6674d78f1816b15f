// Decides how each light step gathers: the number of rays, the length of the histories, and whether the
// light has converged. It uses no GL, so that unit tests can run it alone.
#pragma once

#include <cstdint>

#include "engine/settings.h"

namespace vct {

// The parameters of one light step (shaders/shared/layout.h: LightStep). A round is a group of steps that
// visits each direction of the set once.
struct GatherStep {
    std::uint32_t frame = 0;          // number of the step
    std::uint32_t direction = 0;      // index of the first direction, if the step has no budget
    std::uint32_t rays = 0;           // per face
    std::uint32_t initialRays = 0;    // per face without a history
    std::uint32_t rayBudget = 0;      // rays of the whole step, for which faces take turns; 0: no limit
    bool beginsRound = false;         // the step is the first of a round
    float roundShare = 0.0F;          // weight of the step in its round; 0 outside of rounds
    float history = 0.0F;             // maximum history length, in steps
    float longEnough = 0.0F;          // faces with a history of this length do not gather; 0: all do
    float minHistory = 0.0F;          // minimum history length after the step; large once light has converged
    float previousStepWeight = 0.0F;  // weight that the previous step had in the histories
    float energyCorrection = 0.0F;    // share of the global energy correction that the step applies
    float smoothing = 0.0F;           // maximum weight of the block's mean in a face's irradiance, 0..1
};

class GatherSchedule {
  public:
    // `lightFrames`: steps after a change, without the refinement. A refinement follows if they hold at
    // least two rounds and the settings ask for more directions.
    GatherSchedule(const GatherSettings& settings, int lightFrames);

    // A change of the voxels in the time between two steps.
    struct Change {
        bool lists = false;           // lists of faces were rebuilt
        std::uint32_t voxelized = 0;  // a bit for each cascade whose static geometry was voxelized
        bool light = false;           // the light or the occluders have changed
        bool cascades = false;        // cascades have moved with the camera
        bool any() const { return lists || light || cascades; }
    };
    // Returns the parameters of the next step.
    GatherStep advance(const Change& change);
    // Makes the next step start without histories.
    void invalidate();

    // Steps from a change to convergence, refinement included.
    int convergenceSteps() const { return lightFrames_ + refinementSteps_; }
    // True if another step would change nothing, as long as nothing else changes.
    bool isConverged() const { return stepsLeft_ == 0; }

  private:
    // The length in steps of the next step's round, and the step's position in it. Length 0: no round.
    struct Round {
        int length = 0, place = 0;
    };
    Round round(bool changed) const;

    int rays_, rayBudget_, lightFrames_, convergenceRound_, refinementSteps_;
    int stepsLeft_ = 0;
    bool lastStepUnchanged_ = true;  // nothing changed before the last step
    float history_ = 0.0F;           // length of the histories, in steps
    float lastShare_ = 0.0F;         // weight of the last step in the histories
    float smoothing_ = 0.0F;
    int movedStepsLeft_ = 0;  // steps with a budget that are left after cascades have moved
    std::uint32_t frame_ = 0, direction_ = 0;
};

}  // namespace vct
