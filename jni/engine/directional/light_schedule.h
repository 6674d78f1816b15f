// Decides what each light step does. It uses no GL, so that unit tests can run it alone.
//
// Each step lights all faces from the hits of their cached rays, so it adds one bounce; the first steps,
// whose picture starts dark, add four. After a change there are three states: `lightFrames` steps add
// bounces; then, if the settings ask for it, further rays refine the means; then the light has converged, and
// no step runs until something changes. After a move of cascades the steps visit only the faces that it has
// changed, and trace their rays at a slower pace, because these faces show the light of a coarser cascade
// meanwhile. The step of the move itself, which has new faces to voxelize, does not gather.
//
// With cascades, other changes reach the cascades in turns, because an object that moves changes little of
// the coarse ones: each step visits the finest cascade and one of the others, until all have been visited
// since the last change.
#pragma once

#include <cstdint>

#include "engine/settings.h"

namespace vct {

// The parameters of one light step (shaders/shared/layout.h: LightStep).
struct LightPlan {
    std::uint32_t step = 0;             // number of the step
    std::uint32_t movingRays = 0;       // rays of all faces of moving objects together that are traced again
    std::uint32_t minMovingRays = 0;    // and at least so many of each of these faces
    int refiningStep = -1;              // number of the step in the refinement; -1: it does not refine
    int refiningSteps = 0;              // steps of the refinement
    bool interrupts = false;            // the step ends a refinement too early
    bool gathers = true;                // faces find the light that they receive
    bool traces = false;                // cached rays may be unknown or out of date
    bool startsDark = false;            // no face had light before its first rays
    int bounces = 1;                    // times that the faces find the light that they receive
    bool visitsAll = true;              // the step visits all faces; false: a list of them
    bool listsVisited = false;          // the faces of that list have changed
    std::uint32_t visitedCascades = 0;  // the list has all faces of these cascades, a bit for each
    bool findsBlocked = false;       // the rays of the visited faces that moving objects block have changed
    std::uint32_t visitsSince = 0;   // step, counted from 1, since which the faces of the list have changed
    bool updatesDirect = false;      // direct light has changed
    bool updatesSky = false;         // the sky has changed
    bool updatesEmitters = false;    // the light of compact emitters has changed
    std::uint32_t emitterTurns = 1;  // new faces find the emitters' light in so many steps

    bool endsRefinement() const { return refiningStep >= 0 && refiningStep == refiningSteps - 1; }
};

class LightSchedule {
  public:
    LightSchedule(const GatherSettings& settings, int lightFrames, int cascades);

    // A change of the voxels in the time between two steps.
    struct Change {
        bool lists = false;           // lists of faces were rebuilt
        std::uint32_t voxelized = 0;  // a bit for each cascade whose static geometry was voxelized
        bool light = false;           // the light or the occluders have changed
        bool emitters = false;        // emitters or occluders have changed
        bool sky = false;             // the sky has changed
        bool all = false;             // dynamic objects have another pose, or a cascade has jumped
        bool cascades = false;        // cascades have moved with the camera
        bool any() const { return lists || light || emitters || sky || cascades; }
        // True if nothing else has changed than the places of cascades.
        bool isMove() const { return any() && !(light || emitters || sky || all); }
    };
    // New faces of cascades that have moved show the emitters' light on faces of a coarser cascade until
    // they find their own, in so many steps.
    static constexpr int emitterTurns = 16;
    // Returns the parameters of the next step.
    LightPlan advance(const Change& change);
    // The faces have light before the first step.
    void startLit() { startsDark_ = false; }
    // The last step has taken over converged light, without rays.
    void end() {
        stepsLeft_ = 0;
        tracingStepsLeft_ = tracingSteps_;
    }

    // Steps from a change to convergence.
    int convergenceSteps() const { return lightFrames_ + refiningSteps_; }
    // Steps that are left to convergence, as long as nothing changes.
    int stepsLeft() const { return stepsLeft_; }
    // True if another step would change nothing, as long as nothing else changes.
    bool isConverged() const { return stepsLeft_ == 0; }

  private:
    void takeTurn(LightPlan& plan, bool isFirst);

    int lightFrames_, cascades_, refiningSteps_, tracingSteps_, rayBudget_, rays_;
    int moveSteps_;  // steps after a move, before a refinement
    int stepsLeft_, tracingStepsLeft_, emitterStepsLeft_ = 0;
    std::uint32_t step_ = 0;
    // The step, counted from 1, in which light changed everywhere; 0: a refinement has visited all since.
    std::uint32_t changedAll_ = 0;
    std::uint32_t outdated_ = 0;  // cascades that no step has visited since the last change, a bit for each
    bool outdatedEmitters_ = false;  // it has changed the light of emitters
    int turn_ = 0;                   // the cascade whose turn was the last
    bool startsDark_ = true;
    bool visitedAll_ = true;             // in the last step
    std::uint32_t visitedCascades_ = 0;  // in the last step
    bool gathered_ = true;               // in the last step
};

}  // namespace vct
