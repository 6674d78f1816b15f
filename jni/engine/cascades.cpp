#include "engine/cascades.h"

#include <algorithm>
#include <cmath>

namespace vct {

Cascades::Cascades(int count, int grid) : count_(count), grid_(grid) {
    for (int i = 0; i < count; ++i)
        corners_[static_cast<std::size_t>(i)] = glm::dvec3(0.5 - 0.5 * side(i));
}

double Cascades::side(int cascade) const {
    return std::ldexp(1.0, cascade + 1 - count_);
}

bool Cascades::follow(const glm::dvec3& eye) {
    // The distance of each cascade from its place, in its steps.
    std::array<double, VCT_MAX_CASCADES> away{};
    const auto cornerFor = [&](int i) { return glm::clamp(eye - 0.5 * side(i), 0.0, 1.0 - side(i)); };
    const auto stepOf = [&](int i) { return side(i) * brickVoxels / grid_; };
    int farthest = 0;
    for (int i = 0; i + 1 < count_; ++i) {
        const glm::dvec3 offset = glm::abs(cornerFor(i) - corners_[static_cast<std::size_t>(i)]) / stepOf(i);
        away[static_cast<std::size_t>(i)] = std::max({offset.x, offset.y, offset.z});
        if (away[static_cast<std::size_t>(i)] > away[static_cast<std::size_t>(farthest)]) farthest = i;
    }
    bool hasMoved = false;
    for (int i = 0; i + 1 < count_; ++i) {
        const double distance = away[static_cast<std::size_t>(i)];
        const bool moves = !isPlaced_ || distance >= 1.5 || (i == farthest && distance > 0.75);
        if (!moves) continue;
        glm::dvec3& corner = corners_[static_cast<std::size_t>(i)];
        const glm::dvec3 before = corner;
        const double step = stepOf(i);
        for (int axis = 0; axis < 3; ++axis)
            if (!isPlaced_ || std::abs(cornerFor(i)[axis] - corner[axis]) > 0.75 * step)
                corner[axis] = step * std::round(cornerFor(i)[axis] / step);
        hasMoved |= corner != before;
    }
    isPlaced_ = true;
    return hasMoved;
}

}  // namespace vct
