// Time per step of the frame by the thesis's method (5.1.2): glFinish, then the CPU's clock.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace vct {

// The columns of the thesis's table 5.3: CS, RT, V, M, Tr.
enum class Step { shadowMap, renderData, voxelize, mipmap, trace };
constexpr int stepCount = 5;
const char* stepName(Step step);  // "shadow_map", "render_data", "voxelize", "mipmap", "trace"

// Milliseconds of every timed frame.
struct StepTimes {
    std::array<std::vector<double>, stepCount> stepMs;
    std::vector<double> totalMs;  // the row sum, per frame
};

double median(std::vector<double> samples);  // 0 for none

// Does nothing (not even glFinish) unless recording.
class StepTimer {
  public:
    void startRecording();
    StepTimes stopRecording();

    void beginFrame();
    void endFrame();
    // Runs `work` and, when recording, adds its time to the step of the current frame.
    template <typename Work>
    auto time(Step step, Work&& work) {
        Scope scope(*this, step);
        return work();
    }

  private:
    struct Scope {
        StepTimer& timer;
        Step step;
        double startMs;
        Scope(StepTimer& t, Step s);
        ~Scope();
    };
    bool recording_ = false;
    std::array<double, stepCount> frameMs_{};
    StepTimes times_;
};

}  // namespace vct
