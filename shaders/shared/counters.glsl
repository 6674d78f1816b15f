// Counters for `vct shaders`. COUNT(VCT_COUNTER_...) is at the start of each stage and in each of its loops,
// after any statement that may end the iteration, so that it counts whole iterations. Without
// VCT_SHADER_COUNTERS it does nothing.
#include "shared/layout.h"

#ifdef VCT_SHADER_COUNTERS
layout(std430, binding = VCT_SSBO_COUNTERS) buffer CounterBlock {
    uint counts[VCT_COUNTER_COUNT];
};
#define COUNT(what) atomicAdd(counts[what], 1u)
#else
#define COUNT(what)
#endif
