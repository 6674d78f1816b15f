// How many pixels a frame's time allows: the window's sides over a divisor that follows measured times.
#pragma once

#include <vector>

namespace vct::app {

// Decides by medians, so that one slow frame changes nothing. What a finer scale would take is expected as if
// all of a frame's time grew with its pixels, which is more than it does: the scale does not rise where it
// would have to fall again. Between the time that lets it rise and the one that makes it fall there is a gap
// too, so that noise does not move it to and fro.
class ResolutionScale {
  public:
    static constexpr double maxMs = 15.0;     // of 60 frames a second, less what the system needs to show one
    static constexpr double enoughMs = 12.0;  // up to which it rises
    static constexpr double maxDivisor = 4.0;  // where it stays however long frames take

    // Takes a frame's time in ms, from its start until the GPU has finished it. Returns whether frames to
    // come have another size.
    bool follow(double frameMs);

    // Of the window's sides, from 1 to maxDivisor.
    double divisor() const;

  private:
    std::size_t level_ = 5;        // 1/3: what can do more rises within a second
    std::vector<double> timesMs_;  // of the last frames, all of them at this level
};

}  // namespace vct::app
