// Decides when frames are drawn: at the display's refreshes, evenly, and at most about 60 times a second.
#pragma once

#include <android/choreographer.h>

#include <cstdint>

namespace vct::app {

class FrameClock {
  public:
    // Must be called on a thread with a looper, which then reports refreshes. The object must live as long as
    // the looper is polled. Throws vct::Error.
    FrameClock();
    FrameClock(const FrameClock&) = delete;
    FrameClock& operator=(const FrameClock&) = delete;

    // Asks to wake the looper at the display's next refresh.
    void request();
    // Returns true once after a refresh at which a frame is due. Frames are at least 12 ms apart, so on
    // displays with more than 60 refreshes a second only about every second one counts.
    bool take();

  private:
    AChoreographer* choreographer_;
    bool requested_ = false;
    bool due_ = false;
    std::int64_t lastFrameNs_ = 0;
};

}  // namespace vct::app
