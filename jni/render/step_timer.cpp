#include "render/step_timer.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "gl/api.h"

namespace vct {

namespace {

double finishedAtMs() {
    gl::Finish();
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
}

}  // namespace

const char* stepName(Step step) {
    switch (step) {
        case Step::shadowMap:
            return "shadow_map";
        case Step::renderData:
            return "render_data";
        case Step::voxelize:
            return "voxelize";
        case Step::mipmap:
            return "mipmap";
        case Step::trace:
            return "trace";
    }
    return "";
}

double median(std::vector<double> samples) {
    if (samples.empty()) return 0.0;
    std::sort(samples.begin(), samples.end());
    const std::size_t middle = samples.size() / 2;
    return samples.size() % 2 == 1 ? samples[middle] : 0.5 * (samples[middle - 1] + samples[middle]);
}

void StepTimer::startRecording() {
    recording_ = true;
    times_ = {};
}

StepTimes StepTimer::stopRecording() {
    recording_ = false;
    return std::move(times_);
}

void StepTimer::beginFrame() {
    frameMs_.fill(0.0);
}

void StepTimer::endFrame() {
    if (!recording_) return;
    for (int i = 0; i < stepCount; ++i)
        times_.stepMs[i].push_back(frameMs_[i]);
    times_.totalMs.push_back(std::accumulate(frameMs_.begin(), frameMs_.end(), 0.0));
}

StepTimer::Scope::Scope(StepTimer& t, Step s)
    : timer(t), step(s), startMs(t.recording_ ? finishedAtMs() : 0.0) {}

StepTimer::Scope::~Scope() {
    if (timer.recording_) timer.frameMs_[static_cast<int>(step)] += finishedAtMs() - startMs;
}

}  // namespace vct
