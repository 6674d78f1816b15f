// Axis-aligned boxes.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <vector>

namespace vct {

struct Bounds {
    glm::dvec3 min{0.0};
    glm::dvec3 max{0.0};

    void include(const glm::dvec3& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
};

// Empty bounds: including a point makes them that point.
const Bounds noBounds{glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};

// These bounds hold every position. They are finite, so that shaders can compute with them.
const Bounds everywhere{glm::dvec3(-1e30), glm::dvec3(1e30)};

inline Bounds united(const Bounds& a, const Bounds& b) {
    return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}

// Bounds of the points, transformed by `matrix`.
inline Bounds boundsOf(const std::vector<glm::dvec3>& points, const glm::dmat4& matrix) {
    Bounds bounds = noBounds;
    for (const glm::dvec3& point : points)
        bounds.include(glm::dvec3(matrix * glm::dvec4(point, 1.0)));
    return bounds;
}

inline std::vector<glm::dvec3> cornersOf(const Bounds& bounds) {
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back((i & 1) != 0 ? bounds.max.x : bounds.min.x,
                             (i & 2) != 0 ? bounds.max.y : bounds.min.y,
                             (i & 4) != 0 ? bounds.max.z : bounds.min.z);
    return corners;
}

}  // namespace vct
