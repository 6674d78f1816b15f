#include "engine/step_timer.h"

#include <algorithm>
#include <chrono>

#include "core/number_text.h"
#include "gl/api.h"

namespace vct {

double StepTimer::nowMs() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
}

double StepTimer::finishedAtMs() {
    gl::Finish();
    return nowMs();
}

const char* stepName(Step step) {
    static constexpr std::array<const char*, stepCount> names{
        "shadow_map", "render_data", "voxelize", "inject", "mipmap", "irradiance", "trace"};
    return names[static_cast<std::size_t>(step)];
}

double median(std::vector<double> samples) {
    if (samples.empty()) return 0.0;
    std::sort(samples.begin(), samples.end());
    const std::size_t middle = samples.size() / 2;
    return samples.size() % 2 == 1 ? samples[middle] : 0.5 * (samples[middle - 1] + samples[middle]);
}

std::string whyGpuTimesAreWrong(const StepTimes& times) {
    if (times.gpuMs[0].empty())
        return "the driver has no GL_EXT_disjoint_timer_query, its clock has 0 bits or is known to be wrong, "
               "or it runs on the CPU";
    if (times.gpuDisjoint) return "the driver reported a disjoint operation";
    // Only glFinish's times include the cost of submission, so the times of short steps may differ widely.
    constexpr double longStepMs = 5.0;
    constexpr double minShare = 0.2;
    for (int i = 0; i < stepCount; ++i) {
        const double finishMs = median(times.stepMs[i]);
        const double gpuMs = median(times.gpuMs[i]);
        if (gpuMs > 1.1 * finishMs + 0.2 || (finishMs > longStepMs && gpuMs < minShare * finishMs))
            return std::string("it says ") + numberText(gpuMs) + " ms for " + stepName(static_cast<Step>(i)) +
                   " and glFinish " + numberText(finishMs);
    }
    return "";
}

void StepTimer::startRecording(Clocks clocks) {
    recording_ = true;
    times_ = {};
    if (!hasGpuClock_ || clocks == Clocks::cpu) return;
    gpuTimer_.emplace();
    gl::gpuTimerWasDisjoint();  // clears the flag, which may be set from before the recording
}

StepTimes StepTimer::stopRecording() {
    recording_ = false;
    if (gpuTimer_) times_.gpuDisjoint = gl::gpuTimerWasDisjoint();
    gpuTimer_.reset();
    return std::move(times_);
}

void StepTimer::beginFrame() {
    frameMs_.fill(0.0);
    frameGpuMs_.fill(0.0);
}

void StepTimer::endFrame() {
    if (!recording_) return;
    for (int i = 0; i < stepCount; ++i) {
        times_.stepMs[i].push_back(frameMs_[i]);
        if (gpuTimer_) times_.gpuMs[i].push_back(frameGpuMs_[i]);
    }
}

StepTimer::Scope::Scope(StepTimer& t, Step s)
    : timer(t), step(s), startMs(t.recording_ ? finishedAtMs() : 0.0) {
    if (timer.gpuTimer_) timer.gpuTimer_->begin();
}

StepTimer::Scope::~Scope() {
    if (!timer.recording_) return;
    const auto i = static_cast<std::size_t>(step);
    // The GPU's result is read after the CPU's clock because reading it takes time.
    if (timer.gpuTimer_) timer.gpuTimer_->stop();
    timer.frameMs_[i] += finishedAtMs() - startMs;
    if (timer.gpuTimer_) timer.frameGpuMs_[i] += timer.gpuTimer_->resultMs();
}

}  // namespace vct
