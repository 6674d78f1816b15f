#include "app/android/frame_clock.h"

#include "core/error.h"

namespace vct::app {

namespace {

// Below the refresh of a display of 60 Hz by more than clocks are wrong, and above that of 90 Hz.
constexpr std::int64_t minFrameNs = 12'000'000;

}  // namespace

FrameClock::FrameClock() : choreographer_(AChoreographer_getInstance()) {
    if (choreographer_ == nullptr)
        throw Error("the system does not tell of the display's refreshes; restart the app");
}

void FrameClock::request() {
    if (requested_) return;
    requested_ = true;
    // From Android 10 on there is one whose time has 64 bits everywhere. The app is of 64 bits, as is its
    // long.
    AChoreographer_postFrameCallback(
        choreographer_,
        [](long timeNs, void* data) {
            FrameClock& clock = *static_cast<FrameClock*>(data);
            clock.requested_ = false;
            if (timeNs - clock.lastFrameNs_ < minFrameNs) return;
            clock.lastFrameNs_ = timeNs;
            clock.due_ = true;
        },
        this);
}

bool FrameClock::take() {
    const bool due = due_;
    due_ = false;
    return due;
}

}  // namespace vct::app
