#include "scene/bounds.h"

namespace vct {

Bounds united(const Bounds& a, const Bounds& b) {
    return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}

Bounds boundsOf(const std::vector<glm::dvec3>& points, const glm::dmat4& matrix) {
    Bounds bounds = noBounds;
    for (const glm::dvec3& point : points)
        bounds.include(glm::dvec3(matrix * glm::dvec4(point, 1.0)));
    return bounds;
}

std::vector<glm::dvec3> cornersOf(const Bounds& bounds) {
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back((i & 1) != 0 ? bounds.max.x : bounds.min.x,
                             (i & 2) != 0 ? bounds.max.y : bounds.min.y,
                             (i & 4) != 0 ? bounds.max.z : bounds.min.z);
    return corners;
}

}  // namespace vct
