// The part of space that a pass draws. Instances outside of it are skipped.
#pragma once

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "scene/bounds.h"

namespace vct {

class DrawRegion {
  public:
    // `fromVolume`: projects volume space; the region is projected to [0, w]^3.
    explicit DrawRegion(const glm::dmat4& fromVolume) {
        const glm::dmat4 rows = glm::transpose(fromVolume);
        for (int axis = 0; axis < 3; ++axis) {
            planes_[static_cast<std::size_t>(2 * axis)] = rows[axis];
            planes_[static_cast<std::size_t>(2 * axis + 1)] = rows[3] - rows[axis];
        }
    }
    // The region that a camera sees.
    static DrawRegion inClipSpace(const glm::dmat4& clipFromVolume) {
        glm::dmat4 toUnit(0.5);
        toUnit[3] = glm::dvec4(0.5, 0.5, 0.5, 1.0);
        return DrawRegion(toUnit * clipFromVolume);
    }
    static DrawRegion volume() { return cube(glm::dvec3(0.0), 1.0); }
    // A cube in volume space.
    static DrawRegion cube(const glm::dvec3& corner, double side) { return box({corner, corner + side}); }
    // A box in volume space.
    static DrawRegion box(const Bounds& box) {
        const glm::dvec3 scale = 1.0 / (box.max - box.min);
        glm::dmat4 fromVolume(1.0);
        for (int axis = 0; axis < 3; ++axis)
            fromVolume[axis][axis] = scale[axis];
        fromVolume[3] = glm::dvec4(-box.min * scale, 1.0);
        return DrawRegion(fromVolume);
    }

    // False if a box (volume space) is outside. May return true for a box beside an edge of the region.
    bool meets(const Bounds& box) const {
        const glm::dvec3 centre = 0.5 * (box.min + box.max), half = 0.5 * (box.max - box.min);
        for (const glm::dvec4& plane : planes_) {
            const glm::dvec3 normal(plane);
            // The shaders round positions.
            const double margin = 1e-5 * (glm::dot(glm::abs(normal), glm::abs(centre) + 1.0));
            if (glm::dot(normal, centre) + plane.w + glm::dot(glm::abs(normal), half) < -margin) return false;
        }
        return true;
    }

    // True if the region may hold a part of one of the boxes.
    bool meetsAny(const std::vector<Bounds>& boxes) const {
        return std::any_of(boxes.begin(), boxes.end(), [this](const Bounds& box) { return meets(box); });
    }

  private:
    std::array<glm::dvec4, 6> planes_;  // a point is inside if each product with (x, y, z, 1) is positive
};

}  // namespace vct
