// Axis-aligned boxes.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace vct {

struct Bounds {
    glm::dvec3 min{0.0};
    glm::dvec3 max{0.0};
};

Bounds united(const Bounds& a, const Bounds& b);

// Around `matrix` times each point; of no points an inverted box, which united() takes for nothing.
Bounds boundsOf(const std::vector<glm::dvec3>& points, const glm::dmat4& matrix);

std::vector<glm::dvec3> cornersOf(const Bounds& bounds);

}  // namespace vct
