// How often the shaders of a frame run, and how often their loops do: counted on the driver by the shaders
// themselves (shaders/shared/counters.glsl).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/renderer.h"

namespace vct {

struct LoopCount {
    std::string name;
    int depth;      // 0: in no other loop
    bool constant;  // its length: the compiler may unroll it
    double iterations;
};

struct StageCount {
    std::string shader;  // "passes/shade.frag"
    std::uint32_t invocations;
    std::vector<LoopCount>
        loops;  // in the order they run, a nested one after the one around it; those that ran
};

// Draws two frames, the second as every later one, and counts it. The renderer's settings have
// countInvocations and revoxelize. Fragments are counted before the depth test, in all stages that ran.
std::vector<StageCount> countInvocations(Renderer& renderer, Output mode, const Camera& camera);

}  // namespace vct
