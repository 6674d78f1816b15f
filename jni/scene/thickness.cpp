#include "scene/thickness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "scene/triangle_tree.h"

namespace vct {
namespace {

// Returns the distance at which a ray from inside an instance leaves it, or HUGE_VAL if that is not before
// `longest`. Only the surfaces of that instance count, because solids of others often overlap it.
double exitOf(const TriangleTree& tree, int instance, const glm::dvec3& from, const glm::dvec3& direction,
              double longest) {
    std::vector<std::pair<double, int>>
        hits;  // distance, and 1 where a solid is entered, -1 where it is left
    tree.visit(from, direction, longest, [&](double distance, const TriangleTree::Triangle& triangle) {
        // The surface that the ray starts on is not in its way.
        if (triangle.instance == instance && distance > 1e-6 * longest)
            hits.emplace_back(distance, glm::dot(triangle.areaNormal(), direction) > 0.0 ? -1 : 1);
        return longest;
    });
    std::sort(hits.begin(), hits.end());
    int depth = 1;
    for (const auto& [distance, change] : hits)
        if ((depth += change) == 0) return distance;
    return HUGE_VAL;
}

LocalSize sizeAt(const TriangleTree& tree, int instance, const glm::dvec3& point, const glm::dvec3& inwards,
                 double longest) {
    LocalSize size;
    size.instance = instance;
    size.thickness = exitOf(tree, instance, point, inwards, longest);
    if (size.thickness == HUGE_VAL) return size;
    // Chords through the middle of the solid, at right angles to the thickness.
    const glm::dvec3 middle = point + 0.5 * size.thickness * inwards;
    const glm::dvec3 axis = std::abs(inwards.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(inwards, axis)), y = glm::cross(inwards, x);
    constexpr int directions = 4;
    std::array<double, directions> chords{};
    for (int i = 0; i < directions; ++i) {
        const double angle = 3.14159265358979323846 * i / directions;
        const glm::dvec3 along = std::cos(angle) * x + std::sin(angle) * y;
        chords[static_cast<std::size_t>(i)] =
            exitOf(tree, instance, middle, along, longest) + exitOf(tree, instance, middle, -along, longest);
    }
    const auto narrowest = std::min_element(chords.begin(), chords.end());
    const auto across = static_cast<std::size_t>(narrowest - chords.begin() + directions / 2) % directions;
    std::array<double, 3> sides{size.thickness, *narrowest, chords[across]};
    std::sort(sides.begin(), sides.end());
    size.width = sides[1];
    return size;
}

}  // namespace

std::vector<LocalSize> localSizes(const Scene& scene, std::size_t count, double longest) {
    const TriangleTree tree(scene);
    double area = 0.0;
    for (const TriangleTree::Triangle& triangle : tree.triangles())
        area += glm::length(triangle.areaNormal());
    std::vector<LocalSize> sizes;
    double passed = 0.0;  // area of the triangles before this one
    for (const TriangleTree::Triangle& triangle : tree.triangles()) {
        const glm::dvec3 normal = triangle.areaNormal(), corner(triangle.corners[0]);
        passed += glm::length(normal);
        while (sizes.size() < count &&
               (static_cast<double>(sizes.size()) + 0.5) * area < passed * static_cast<double>(count)) {
            // Points of the R2 sequence (Roberts 2018), folded into the triangle.
            const auto i = static_cast<double>(sizes.size() + 1);
            glm::dvec2 uv = glm::fract(i * glm::dvec2(0.7548776662466927, 0.5698402909980532));
            if (uv.x + uv.y > 1.0) uv = 1.0 - uv;
            const glm::dvec3 point = tree.centre() + corner +
                                     uv.x * (glm::dvec3(triangle.corners[1]) - corner) +
                                     uv.y * (glm::dvec3(triangle.corners[2]) - corner);
            sizes.push_back(sizeAt(tree, triangle.instance, point, -glm::normalize(normal), longest));
        }
    }
    return sizes;
}

}  // namespace vct
