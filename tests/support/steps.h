// The steps that a frame runs.
#pragma once

#include <string>

#include "engine/renderer.h"

namespace vct::test {

// The names of the steps that `frame` runs besides the G-buffer and the trace, "" for none.
template <class Frame>
std::string stepsOf(Renderer& renderer, const Frame& frame) {
    renderer.timer().startRecording(Clocks::cpu);
    frame();
    const StepTimes times = renderer.timer().stopRecording();
    std::string names;
    for (const Step step : {Step::shadowMap, Step::voxelize, Step::inject, Step::mipmap, Step::irradiance})
        if (times.stepMs[static_cast<std::size_t>(step)].at(0) > 0.0)
            names += (names.empty() ? "" : ", ") + std::string(stepName(step));
    return names;
}

}  // namespace vct::test
