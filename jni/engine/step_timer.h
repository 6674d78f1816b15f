// Time per step of the frame by the thesis's method (5.1.2): glFinish, then the CPU's clock. Beside it, in
// the same frames, by the GPU's own clock where it has one.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gl/gpu_timer.h"

namespace vct {

// The columns of the thesis's table 5.3, CS, RT, V, M, Tr; and the injection of light and the irradiance, which it
// does not have.
enum class Step { shadowMap, renderData, voxelize, inject, mipmap, irradiance, trace };
constexpr int stepCount = 7;
// "shadow_map", "render_data", "voxelize", "inject", "mipmap", "irradiance", "trace"
const char* stepName(Step step);

// Milliseconds of every timed frame.
struct StepTimes {
    std::array<std::vector<double>, stepCount> stepMs;
    // By the GPU's clock; empty where it has none.
    std::array<std::vector<double>, stepCount> gpuMs;
    bool gpuDisjoint = false;  // the GPU's clock jumped meanwhile
};

// "" where the GPU's times can be believed beside those of glFinish, or why not: drivers are known that count
// nothing, or something else.
std::string whyGpuTimesAreWrong(const StepTimes& times);

double median(std::vector<double> samples);  // 0 for none

// Which clocks a recording reads. The GPU's is for those who read its times: queries are among what drivers
// get wrong most (gl/driver_faults.h).
enum class Clocks { cpu, cpuAndGpu };

// Does nothing (not even glFinish) unless recording.
class StepTimer {
  public:
    // `gpuTimerBits`: of the context; 0 without a GPU clock that is sound.
    explicit StepTimer(int gpuTimerBits) : hasGpuClock_(gpuTimerBits > 0) {}

    void startRecording(Clocks clocks);
    StepTimes stopRecording();

    void beginFrame();
    void endFrame();
    // Runs `work` and, when recording, adds its time to the step of the current frame.
    template <typename Work>
    auto time(Step step, Work&& work) {
        Scope scope(*this, step);
        return work();
    }
    // Runs work that is the CPU's but for small uploads, and times it without waiting for the GPU, which
    // takes time of its own.
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
    static double finishedAtMs();
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
