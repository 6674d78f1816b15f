// When frames are drawn: at the display's refreshes, at most 60 of them a second and evenly.
#pragma once

#include <android/choreographer.h>

#include <cstdint>

namespace vct::app {

class FrameClock {
  public:
    // On a thread with a looper, which then tells it of refreshes. It must live as long as the looper is
    // polled. Throws vct::Error.
    FrameClock();
    FrameClock(const FrameClock&) = delete;
    FrameClock& operator=(const FrameClock&) = delete;

    // Wakes the looper at the display's next refresh.
    void request();
    // Whether there has been a refresh since that is a frame's turn. On displays that refresh more often than
    // 60 times a second that is every second one, or so: a frame every 12 ms is the most.
    bool take();

  private:
    AChoreographer* choreographer_;
    bool requested_ = false;
    bool due_ = false;
    std::int64_t lastFrameNs_ = 0;
};

}  // namespace vct::app
