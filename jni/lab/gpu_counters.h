// Counters of the GPU's hardware, for platforms that have some.
#pragma once

#include <functional>
#include <string>

namespace vct {

struct GpuCounterValues {
    double cycles = 0.0;                         // in which the GPU was busy
    double readBytes = 0.0, writtenBytes = 0.0;  // traffic with the memory outside the GPU
};

struct GpuCounters {
    std::string missing;                     // why there are none and what to do; empty: read() works
    std::function<GpuCounterValues()> read;  // returns the counts since the last call; throws vct::Error
};

}  // namespace vct
