// Finds the loops of a shader in its source, and makes it count how often it runs and how often each loop
// does, for `vct shaders`.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gl/shader_source.h"

namespace vct {

struct ShaderLoop {
    std::string place;  // "directional/ray.glsl:131"
    int depth;          // number of loops around it
    bool constant;      // its length is constant, so the compiler may unroll it
    std::size_t counter;
};

struct CountedShader {
    std::size_t invocations;  // the counter of main()
    std::size_t counterCount;
    // The loops that main() runs, in their order; a nested loop comes after the one around it. A function's
    // loops are there once for each of its calls, which share the counters.
    std::vector<ShaderLoop> loops;
};

// Changes a fragment or compute shader: main() adds 1 to a counter, and each iteration of a loop to one more.
// The counters are words of the storage buffer VCT_SSBO_COUNTERS, from `firstCounter` on. Throws vct::Error
// at source that it cannot read.
CountedShader countLoops(gl::AssembledShader& source, std::size_t firstCounter);

}  // namespace vct
