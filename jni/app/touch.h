// Fingers into gestures: one orbits, two pinch and pan, a double tap resets. Knows nothing of Android.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace vct::app {

struct TouchPoint {
    int id = 0;
    glm::vec2 position{0.0F};  // pixels from the top left
};

// What the fingers did, in pixels; y points down.
struct Gesture {
    glm::vec2 orbit{0.0F};
    glm::vec2 pan{0.0F};
    float zoom = 1.0F;  // above 1: the fingers moved apart
    bool doubleTap = false;
};

class Touch {
  public:
    // `pixelsPerDp`: screen density over 160 dpi.
    explicit Touch(float pixelsPerDp) : slop_(8.0F * pixelsPerDp), tapDistance_(48.0F * pixelsPerDp) {}

    // `points`: every finger that is down after an event, in any order.
    void update(const std::vector<TouchPoint>& points, double timeS);
    // The system took the fingers away (a system gesture): no tap.
    void cancel();

    // Everything since the last call.
    Gesture take();

  private:
    void finishTap(double timeS);

    float slop_, tapDistance_;
    std::vector<TouchPoint> points_;  // by id, at most the first two
    bool mayBeTap_ = false;           // one finger, that has not moved yet
    glm::vec2 touchPosition_{0.0F};
    double touchStartS_ = 0.0, lastTapS_ = -1.0;
    glm::vec2 lastTapAt_{0.0F};
    Gesture gesture_;
};

}  // namespace vct::app
