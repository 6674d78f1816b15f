// Counts what runs, in the counting variant alone (`vct shaders`): TRIP(VCT_TRIPS_...) stands once at the start of
// a stage and once in each of its loops, behind what may end it: a trip is a whole one. Everywhere else it is nothing.
#include "shared/layout.h"

#ifdef VCT_SHADER_COUNTERS
layout(std430, binding = VCT_SSBO_COUNTERS) buffer TripBlock {
    uint tripCounts[VCT_COUNTER_COUNT];
};
#define TRIP(what) atomicAdd(tripCounts[what], 1u)
#else
#define TRIP(what)
#endif
