// Counters of Arm's GPUs, through the optional library of the APK (app/counters/library.h).
#pragma once

#include "lab/gpu_counters.h"

namespace vct::app {

GpuCounters openGpuCounters();

}  // namespace vct::app
