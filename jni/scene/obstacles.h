// Finds the first surface along a ray, so that a camera in the app can turn around it and does not pass it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace vct {

// A bounding-volume hierarchy over the triangles of a scene at rest. Objects that move and alpha masks
// (leaves, fences) are no obstacles.
class Obstacles {
  public:
    explicit Obstacles(const Scene& scene);

    struct Hit {
        double distance = 0.0;   // in lengths of the ray's direction
        glm::dvec3 normal{0.0};  // world space, unit length, on the side that the ray comes from
    };
    // Returns the first surface between `from` and `from + longest * direction` that is visible from `from`:
    // as in a picture, the back of a single-sided triangle is not.
    std::optional<Hit> first(const glm::dvec3& from, const glm::dvec3& direction, double longest) const;

  private:
    // Positions are relative to the centre of the scene's bounds.
    struct Triangle {
        glm::vec3 corner, edge1, edge2;
        bool doubleSided;
    };
    // A leaf has `count` triangles from `first` on. Another node (`count` is 0) has one child behind it in
    // the list, and the other at `first`.
    struct Node {
        glm::vec3 min, max;
        std::uint32_t first, count;
    };
    void build(std::size_t begin, std::size_t end);

    glm::dvec3 centre_;
    std::vector<Triangle> triangles_;
    std::vector<Node> nodes_;
};

}  // namespace vct
