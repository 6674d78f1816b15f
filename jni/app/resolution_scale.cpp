#include "app/resolution_scale.h"

#include <algorithm>
#include <array>

#include "engine/step_timer.h"

namespace vct::app {

namespace {

// From each divisor to the next the number of pixels changes by a factor of 1.4 to 1.8.
constexpr std::array<double, 7> divisors{1.0, 1.25, 1.5, 2.0, 2.5, 3.0, ResolutionScale::maxDivisor};

constexpr std::size_t framesToFall = 10, framesToRise = 30;

// The finest level at which a frame is expected to take at most `limitMs`, given that it takes `ms` with
// `divisor`.
std::size_t finestWithin(double limitMs, double ms, double divisor) {
    std::size_t level = 0;
    while (level + 1 < divisors.size() &&
           ms * divisor * divisor > limitMs * divisors[level] * divisors[level])
        ++level;
    return level;
}

}  // namespace

double ResolutionScale::divisor() const {
    return divisors.at(level_);
}

bool ResolutionScale::wantsTime() {
    constexpr int period = 8;
    return timesMs_.size() + 1 < framesToRise || timesMs_.back() > maxMs || ++untimedFrames_ >= period;
}

bool ResolutionScale::follow(double frameMs) {
    untimedFrames_ = 0;
    timesMs_.push_back(frameMs);
    std::size_t wanted = level_;
    if (timesMs_.size() >= framesToFall) {
        const double ms = median({timesMs_.end() - framesToFall, timesMs_.end()});
        if (ms > maxMs) wanted = std::max(level_ + 1, finestWithin(maxMs, ms, divisor()));
    }
    if (timesMs_.size() == framesToRise) {
        const std::size_t finest = finestWithin(enoughMs, median(timesMs_), divisor());
        if (wanted == level_) wanted = std::min(level_, finest);
        timesMs_.erase(timesMs_.begin());
    }
    return setLevel(std::max(wanted, finestByHeat_));
}

bool ResolutionScale::followHeat(float headroom) {
    if (headroom > maxHeadroom)
        finestByHeat_ = std::min(level_ + 1, divisors.size() - 1);
    else if (headroom < coolHeadroom && finestByHeat_ > 0)
        --finestByHeat_;
    return setLevel(std::max(level_, finestByHeat_));
}

bool ResolutionScale::setLevel(std::size_t level) {
    level = std::min(level, divisors.size() - 1);
    if (level == level_) return false;
    level_ = level;
    timesMs_.clear();
    return true;
}

}  // namespace vct::app
