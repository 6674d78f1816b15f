#include "app/android/gpu_counters.h"

#include <dlfcn.h>

#include "app/counters/library.h"
#include "core/error.h"

namespace vct::app {

GpuCounters openGpuCounters() {
    void* const library = dlopen("libvct_counters.so", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
        return {"the app is built without libGPUCounters; build it with the CMake option VCT_GPU_COUNTERS",
                {}};
    const auto start = reinterpret_cast<decltype(&vctStartCounters)>(dlsym(library, "vctStartCounters"));
    const auto read = reinterpret_cast<decltype(&vctReadCounters)>(dlsym(library, "vctReadCounters"));
    if (const char* const reason = start()) return {reason, {}};
    return {"", [read] {
                VctCounts counts{};
                if (const char* const reason = read(&counts)) throw Error(reason);
                return GpuCounterValues{counts.cycles, counts.readBytes, counts.writtenBytes};
            }};
}

}  // namespace vct::app
