// Measures the time of each step of a frame by the thesis's method (5.1.2): glFinish, then the CPU's clock.
// If the GPU has a clock, the same frames are also timed by it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gl/gpu_timer.h"

namespace vct {

// The columns CS, RT, V, M and Tr of the thesis's table 5.3, and two steps that the thesis does not have:
// `inject` and `irradiance`.
enum class Step { shadowMap, renderData, voxelize, inject, mipmap, irradiance, trace };
constexpr int stepCount = 7;
// "shadow_map", "render_data", "voxelize", "inject", "mipmap", "irradiance", "trace"
const char* stepName(Step step);

// Milliseconds of every timed frame.
struct StepTimes {
    std::array<std::vector<double>, stepCount> stepMs;
    // Times by the GPU's clock; empty if it has none.
    std::array<std::vector<double>, stepCount> gpuMs;
    bool gpuDisjoint = false;  // the GPU's clock jumped while it was read
};

// Returns why the GPU's times are not credible beside those of glFinish, or "" if they are. Some drivers
// report no time or a wrong one.
std::string whyGpuTimesAreWrong(const StepTimes& times);

double median(std::vector<double> samples);  // 0 if there are none

// The clocks that a recording reads. The GPU's clock is optional because drivers often implement its queries
// wrongly (gl/driver_faults.h).
enum class Clocks { cpu, cpuAndGpu };

// Measures only between startRecording() and stopRecording(). Outside of them it does not call glFinish.
class StepTimer {
  public:
    // `gpuTimerBits`: bits of the context's GPU clock; 0 if there is none or it is known to be wrong.
    explicit StepTimer(int gpuTimerBits) : hasGpuClock_(gpuTimerBits > 0) {}

    static double finishedAtMs();  // waits for the GPU and returns the time of the CPU's clock

    void startRecording(Clocks clocks);
    StepTimes stopRecording();

    void beginFrame();
    void endFrame();
    // Runs `work` and, when recording, adds its time to the step's time in the current frame.
    template <typename Work>
    auto time(Step step, Work&& work) {
        Scope scope(*this, step);
        return work();
    }
    // The same for work on the CPU with small uploads at most. It does not wait for the GPU, because the
    // wait would take longer than the work.
    template <typename Work>
    void timeOnCpu(Step step, Work&& work) {
        if (!recording_) {
            work();
            return;
        }
        const double startMs = nowMs();
        work();
        frameMs_[static_cast<std::size_t>(step)] += nowMs() - startMs;
    }

  private:
    static double nowMs();
    struct Scope {
        StepTimer& timer;
        Step step;
        double startMs;
        Scope(StepTimer& t, Step s);
        ~Scope();
    };
    bool hasGpuClock_;
    bool recording_ = false;
    std::optional<gl::GpuTimer> gpuTimer_;
    std::array<double, stepCount> frameMs_{}, frameGpuMs_{};
    StepTimes times_;
};

}  // namespace vct
