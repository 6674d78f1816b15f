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

// Around nothing: the first point that it includes is all of it.
const Bounds noBounds{glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};

Bounds united(const Bounds& a, const Bounds& b);

// Around `matrix` times each point.
Bounds boundsOf(const std::vector<glm::dvec3>& points, const glm::dmat4& matrix);

std::vector<glm::dvec3> cornersOf(const Bounds& bounds);

}  // namespace vct
