// Counts how often the shaders of a frame and their loops run. The shaders themselves count
// (shaders/shared/counters.glsl).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/renderer.h"

namespace vct {

struct LoopCount {
    std::string name;
    int depth;      // number of loops around it
    bool constant;  // its length is constant, so the compiler may unroll it
    double iterations;
};

struct StageCount {
    std::string shader;  // "passes/shade.frag"
    std::uint32_t invocations;
    // The loops that ran, in their order; a nested loop comes after the one around it.
    std::vector<LoopCount> loops;
};

// Renders two frames and counts the second one, which represents all later ones. The renderer's settings must
// have countInvocations and revoxelize. Fragments are counted before the depth test. Returns the stages that
// ran.
std::vector<StageCount> countInvocations(Renderer& renderer, Output mode, const Camera& camera);

}  // namespace vct
