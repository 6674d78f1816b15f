// The interface of libvct_counters.so, the optional library of the APK that reads counters of Arm's GPUs. It
// is a library of its own because its tables of all GPUs take 2 MB and are made when it is loaded.
#pragma once

extern "C" {

struct VctCounts {
    double cycles, readBytes, writtenBytes;  // as GpuCounterValues (lab/gpu_counters.h)
};

// Starts counting. Returns null, or the reason why this device has no counters.
const char* vctStartCounters();

// Writes the counts since the last call. Returns null, or what failed.
const char* vctReadCounters(VctCounts* counts);
}
