#include "app/android/frame_clock.h"

#include "core/error.h"

namespace vct::app {

namespace {

// Shorter than a refresh at 60 Hz (16.7 ms), with a margin for inexact clocks, and longer than one at 90 Hz
// (11.1 ms).
constexpr std::int64_t minFrameNs = 12'000'000;

}  // namespace

FrameClock::FrameClock() : choreographer_(AChoreographer_getInstance()) {
    if (choreographer_ == nullptr)
        throw Error("cannot get the display's refresh signal (AChoreographer); restart the app");
}

void FrameClock::request() {
    if (requested_) return;
    requested_ = true;
    // Android 10 has a variant with a 64-bit time. This one passes a `long`, which has 64 bits too, because
    // the app is built for 64-bit processors only.
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
