// Chooses the size of rendered pictures by measured frame times: the window's sides over a divisor.
#pragma once

#include <vector>

namespace vct::app {

// Decides by medians, so that one slow frame changes nothing. To predict the time at a finer resolution, it
// assumes that the whole time of a frame grows with its pixels. That overestimates, so the resolution never
// rises only to fall again. The two limits also lie apart, so that noise does not make it oscillate.
class ResolutionScale {
  public:
    // Above this the resolution falls: a frame at 60 Hz (16.7 ms) less the system's time to show it.
    static constexpr double maxMs = 15.0;
    // The resolution rises if the predicted time is below this.
    static constexpr double enoughMs = 12.0;
    static constexpr double maxDivisor = 4.0;  // the resolution falls no further

    // Takes a frame's time in ms, from its start until the GPU has finished it. Returns true if the following
    // frames have another size.
    bool follow(double frameMs);

    // Divisor of the window's sides, from 1 to maxDivisor.
    double divisor() const;

  private:
    std::size_t level_ = 5;        // begins at 1/3; a fast GPU rises within a second
    std::vector<double> timesMs_;  // times of the last frames at this level
};

}  // namespace vct::app
