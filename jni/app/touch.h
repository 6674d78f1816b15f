// Turns fingers into gestures: one finger orbits, two zoom and pan, a double tap resets. Knows nothing of
// Android.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace vct::app {

struct TouchPoint {
    int id = 0;
    glm::vec2 position{0.0F};  // pixels from the top left
};

// A movement of fingers, in pixels; y points down.
struct Gesture {
    // Middle of the fingers, if another number of them has touched the screen. The movement begins there.
    std::optional<glm::vec2> begin;
    glm::vec2 orbit{0.0F};
    glm::vec2 pan{0.0F};
    float zoom = 1.0F;  // above 1 if the fingers moved apart
    bool doubleTap = false;
};

class Touch {
  public:
    // `pixelsPerDp`: screen density over 160 dpi.
    explicit Touch(float pixelsPerDp) : slop_(8.0F * pixelsPerDp), tapDistance_(48.0F * pixelsPerDp) {}

    // `points`: every finger that is down after an event, in any order.
    void update(const std::vector<TouchPoint>& points, double timeS);
    // Drops the fingers, because the system has taken them for a gesture of its own.
    void cancel();

    // Returns the gesture since the last call.
    Gesture take();

  private:
    void finishTap(double timeS);

    float slop_, tapDistance_;
    std::vector<TouchPoint> points_;  // sorted by id, at most two
    bool mayBeTap_ = false;           // one finger that has not moved yet
    glm::vec2 touchPosition_{0.0F};
    double touchStartS_ = 0.0, lastTapS_ = -1.0;
    glm::vec2 lastTapAt_{0.0F};
    Gesture gesture_;
};

}  // namespace vct::app
