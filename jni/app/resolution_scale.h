// Chooses the size of rendered pictures by measured frame times and by heat: the window's sides over a
// divisor.
#pragma once

#include <cstddef>
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

    // Limits of thermal headroom. Android scales it so that 1 is the start of severe throttling and a
    // difference of 1 is 30 K. Above the first limit, 6 K below severe throttling, the resolution falls;
    // below the second one, 9 K below it, it may rise again.
    static constexpr float maxHeadroom = 0.8F;
    static constexpr float coolHeadroom = 0.7F;
    // Time between two decisions about heat. A phone's case takes that long to follow the GPU's power.
    static constexpr double heatPeriodS = 10.0;

    // True if the next frame's time is needed: each one until there are enough for a decision, then one in
    // eight, and each one again while frames are too slow.
    bool wantsTime();

    // Takes a frame's time in ms, from its start until the GPU has finished it. Returns true if the following
    // frames have another size.
    bool follow(double frameMs);

    // Takes the headroom of a device that tells it, every heatPeriodS. The resolution falls by a level each
    // time that the device is too hot, before throttling would lower the GPU's clock. Returns true if the
    // following frames have another size.
    bool followHeat(float headroom);
    bool isLimitedByHeat() const { return finestByHeat_ > 0 && level_ <= finestByHeat_; }

    // Divisor of the window's sides, from 1 to maxDivisor.
    double divisor() const;

  private:
    bool setLevel(std::size_t level);

    std::size_t level_ = 5;         // begins at 1/3; a fast GPU rises within a second
    std::size_t finestByHeat_ = 0;  // the finest level that heat allows
    std::vector<double> timesMs_;   // times of the last timed frames at this level
    int untimedFrames_ = 0;         // since the last of them
};

}  // namespace vct::app
