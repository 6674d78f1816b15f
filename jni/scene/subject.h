// Finds the objects that a scene is about, without the ground that they stand on.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace vct {

struct Subject {
    Bounds boundsWorld;          // of all instances but the ground, in all poses
    std::vector<bool> isGround;  // per instance
    bool hasGround = false;
};

// The ground is a flat instance under all others that reaches far beyond them in all of their poses, and does
// not move.
Subject subjectOf(const Scene& scene);

// True if the scene is one small object, or a few on a ground: what a photographer would take to a studio.
bool isProduct(const Scene& scene);

}  // namespace vct
