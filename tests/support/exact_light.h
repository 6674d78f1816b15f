// Where the sun reaches, by rays: what a shadow map is measured against.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace vct::test {

class ExactLight {
  public:
    explicit ExactLight(const Scene& scene);

    // The triangle that a point is on, or -1; `normal`: of the side that is seen.
    int triangleAt(const glm::dvec3& position, const glm::dvec3& normal) const;

    // The nearest point of a triangle's plane.
    glm::dvec3 onPlane(const glm::dvec3& position, int triangle) const;

    // Whether that plane's triangles cover a point of it.
    bool covered(const glm::dvec3& position, int triangle) const;

    // Whether nothing is between a point of a triangle and a sun without a size. Triangles of its plane block
    // nothing.
    bool sees(const glm::dvec3& position, int triangle, const glm::dvec3& towardsLight) const;

    // Whether what the sun sees first, along a ray past a point, is no farther from it than `reach`, with the
    // lit side towards it.
    bool litNeighbour(const glm::dvec3& position, const glm::dvec3& ray, const glm::dvec3& towardsLight,
                      double reach) const;

    // To the nearest triangle of another plane, or `limit` where that is nearer.
    double distanceToOthers(const glm::dvec3& position, int triangle, double limit) const;

    struct Triangle {
        glm::dvec3 a, b, c, normal;  // normal: unit length
        bool doubleSided;
    };
    const std::vector<Triangle>& triangles() const { return triangles_; }

  private:
    bool coplanar(int a, std::size_t b) const {
        return coplanar_[static_cast<std::size_t>(a) * triangles_.size() + b] != 0;
    }
    std::vector<Triangle> triangles_;
    std::vector<char> coplanar_;  // a row per triangle
    double tolerance_;            // world; floats and 24 bits of depth are nearer to the truth
};

}  // namespace vct::test
