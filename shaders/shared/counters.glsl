// Counts what runs, in the counting variant alone (`vct shaders`): COUNT(VCT_COUNTER_...) stands once at the start of
// a stage and once in each of its loops, behind what may end it: so that whole ones are counted. Everywhere else it is nothing.
#include "shared/layout.h"

#ifdef VCT_SHADER_COUNTERS
layout(std430, binding = VCT_SSBO_COUNTERS) buffer CounterBlock {
    uint counts[VCT_COUNTER_COUNT];
};
#define COUNT(what) atomicAdd(counts[what], 1u)
#else
#define COUNT(what)
#endif
