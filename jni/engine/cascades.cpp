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
    bool hasMoved = false;
    for (int i = 0; i + 1 < count_; ++i) {
        const double step = side(i) * brickVoxels / grid_;
        glm::dvec3& corner = corners_[static_cast<std::size_t>(i)];
        const glm::dvec3 before = corner;
        for (int axis = 0; axis < 3; ++axis) {
            const double wanted = std::clamp(eye[axis] - 0.5 * side(i), 0.0, 1.0 - side(i));
            if (isPlaced_ && std::abs(wanted - corner[axis]) <= 0.75 * step) continue;
            corner[axis] = step * std::round(wanted / step);
        }
        hasMoved |= corner != before;
    }
    isPlaced_ = true;
    return hasMoved;
}

}  // namespace vct
