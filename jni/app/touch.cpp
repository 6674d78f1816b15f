#include "app/touch.h"

#include <algorithm>
#include <utility>

namespace vct::app {

namespace {

// As in Android's ViewConfiguration: the longest touch that is a tap, and the longest time between the taps
// of a double tap.
constexpr double longestTapS = 0.3;
constexpr double longestDoubleTapS = 0.3;

bool sameFingers(const std::vector<TouchPoint>& a, const std::vector<TouchPoint>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const TouchPoint& x, const TouchPoint& y) { return x.id == y.id; });
}

}  // namespace

void Touch::update(const std::vector<TouchPoint>& all, double timeS) {
    std::vector<TouchPoint> points = all;
    std::sort(points.begin(), points.end(),
              [](const TouchPoint& a, const TouchPoint& b) { return a.id < b.id; });
    if (points.size() > 2) points.resize(2);

    if (!sameFingers(points, points_)) {
        // When a finger is put down or lifted nothing moves yet; the next positions are compared with these.
        if (points_.empty() && points.size() == 1) {
            mayBeTap_ = true;
            touchPosition_ = points[0].position;
            touchStartS_ = timeS;
        } else if (points.empty() && mayBeTap_) {
            finishTap(timeS);
        }
        if (points.size() != 1) mayBeTap_ = false;
        points_ = std::move(points);
        if (!points_.empty()) gesture_.begin = 0.5F * (points_.front().position + points_.back().position);
        return;
    }
    if (points.size() == 1) {
        if (mayBeTap_ && glm::distance(points[0].position, touchPosition_) < slop_) return;
        mayBeTap_ = false;
        gesture_.orbit += points[0].position - points_[0].position;
    } else if (points.size() == 2) {
        const glm::vec2 before = points_[0].position - points_[1].position;
        const glm::vec2 after = points[0].position - points[1].position;
        gesture_.pan +=
            0.5F * (points[0].position + points[1].position - points_[0].position - points_[1].position);
        // The ratio of distances below the slop would be too inexact.
        if (std::min(glm::length(before), glm::length(after)) > slop_)
            gesture_.zoom *= glm::length(after) / glm::length(before);
    }
    points_ = std::move(points);
}

void Touch::finishTap(double timeS) {
    mayBeTap_ = false;
    if (timeS - touchStartS_ > longestTapS) return;
    const bool second = lastTapS_ >= 0.0 && touchStartS_ - lastTapS_ <= longestDoubleTapS &&
                        glm::distance(touchPosition_, lastTapAt_) <= tapDistance_;
    gesture_.doubleTap = gesture_.doubleTap || second;
    lastTapS_ = second ? -1.0 : timeS;  // a third tap counts as a first one
    lastTapAt_ = touchPosition_;
}

void Touch::cancel() {
    points_.clear();
    mayBeTap_ = false;
}

Gesture Touch::take() {
    return std::exchange(gesture_, Gesture{});
}

}  // namespace vct::app
