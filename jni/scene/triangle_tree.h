// Finds the surfaces of a scene along rays, on the CPU: what a view shows, where light arrives, how thick a
// wall is, and what is in the way of the app's camera.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace vct {

// The first surface along a ray. As in a rendered picture, the back of a single-sided triangle is invisible.
struct FirstSurface {
    double distance = 0.0;      // in lengths of the ray's direction; 0: no surface
    glm::dvec3 normal{0.0};     // world space, unit length, on the visible side
    int instance = -1;          // index into Scene::instances
    double backDistance = 0.0;  // of an invisible back that is nearer or coincides; 0: none
};

// A bounding-volume hierarchy over the triangles of a scene at rest. Holes of alpha masks are ignored.
class TriangleTree {
  public:
    enum class Contents {
        all,
        obstacles,  // without objects that move and alpha masks (leaves, fences)
    };
    explicit TriangleTree(const Scene& scene, Contents contents = Contents::all);

    // Corners are counter-clockwise seen from the front, relative to centre().
    struct Triangle {
        glm::vec3 corners[3];
        int instance;
        bool isDoubleSided;

        // Points away from the front; its length is twice the area.
        glm::dvec3 areaNormal() const;
    };
    const std::vector<Triangle>& triangles() const { return triangles_; }
    const glm::dvec3& centre() const { return centre_; }  // world

    // Returns the first surface between `fromWorld` and `fromWorld + longest * direction`. Of two that
    // coincide (a floor, and the underside of an object on it) the larger triangle counts.
    FirstSurface first(const glm::dvec3& fromWorld, const glm::dvec3& direction,
                       double longest = HUGE_VAL) const;

    // Calls visit(distance, triangle) for the triangles that a ray meets before `longest`, in no order. It
    // returns the length of the ray from then on.
    template <class Visit>
    void visit(const glm::dvec3& fromWorld, const glm::dvec3& direction, double longest, Visit visit) const;

  private:
    // A leaf has `count` triangles from `first` on. Another node (`count` is 0) has one child behind it in
    // the list, and the other at `first`.
    struct Node {
        glm::vec3 min, max;
        std::uint32_t first, count;
    };
    void build(std::size_t begin, std::size_t end);
    // Returns the distance of a triangle; below 0 if the ray does not meet it.
    static double distanceOf(const Triangle& triangle, const glm::dvec3& from, const glm::dvec3& direction);

    glm::dvec3 centre_;
    std::vector<Triangle> triangles_;
    std::vector<Node> nodes_;
};

template <class Visit>
void TriangleTree::visit(const glm::dvec3& fromWorld, const glm::dvec3& direction, double longest,
                         Visit visit) const {
    const glm::dvec3 from = fromWorld - centre_;
    glm::dvec3 inverse;
    for (int i = 0; i < 3; ++i)
        inverse[i] = 1.0 / (direction[i] == 0.0 ? 1e-200 : direction[i]);
    // Splits at the median make a tree of 2^32 triangles 32 levels deep.
    std::array<std::uint32_t, 64> open;
    std::size_t count = 0;
    if (!nodes_.empty()) open[count++] = 0;
    while (count > 0) {
        const std::uint32_t index = open[--count];
        const Node& node = nodes_[index];
        const glm::dvec3 a = (glm::dvec3(node.min) - from) * inverse;
        const glm::dvec3 b = (glm::dvec3(node.max) - from) * inverse;
        const glm::dvec3 in = glm::min(a, b), out = glm::max(a, b);
        constexpr double rounding = 1.0 + 1e-12;
        if (std::max({in.x, in.y, in.z, 0.0}) > rounding * std::min({out.x, out.y, out.z, longest})) continue;
        if (node.count == 0) {
            const Node &one = nodes_[index + 1], &other = nodes_[node.first];
            const glm::vec3 offset = one.min + one.max - other.min - other.max;
            const bool isOneNearer = glm::dot(direction, glm::dvec3(offset)) < 0.0;
            open[count++] = isOneNearer ? node.first : index + 1;
            open[count++] = isOneNearer ? index + 1 : node.first;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const double distance = distanceOf(triangles_[i], from, direction);
            if (distance > 0.0 && distance <= longest) longest = visit(distance, triangles_[i]);
        }
    }
}

}  // namespace vct
