#include "scene/parts.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <tuple>

namespace vct {

namespace {

using Triangle = std::array<std::uint32_t, 3>;  // indices of vertices

// Disjoint sets of vertices (union-find).
class Sets {
  public:
    explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
    std::uint32_t find(std::uint32_t vertex) {
        while (parent_[vertex] != vertex)
            vertex = parent_[vertex] = parent_[parent_[vertex]];
        return vertex;
    }
    void join(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

  private:
    std::vector<std::uint32_t> parent_;
};

// Splits a mesh into connected pieces. Vertices at the same position are connected, whatever their normals.
std::vector<std::vector<Triangle>> connectedTriangles(const Mesh& mesh) {
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        const glm::vec3 &p = mesh.vertices[a].position, &q = mesh.vertices[b].position;
        return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    };
    std::vector<std::uint32_t> sorted(mesh.vertices.size());
    std::iota(sorted.begin(), sorted.end(), 0U);
    std::sort(sorted.begin(), sorted.end(), before);
    Sets sets(mesh.vertices.size());
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (!before(sorted[i - 1], sorted[i])) sets.join(sorted[i - 1], sorted[i]);
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        sets.join(mesh.indices[i], mesh.indices[i + 1]);
        sets.join(mesh.indices[i], mesh.indices[i + 2]);
    }
    std::map<std::uint32_t, std::vector<Triangle>> pieces;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        pieces[sets.find(mesh.indices[i])].push_back(
            {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    std::vector<std::vector<Triangle>> found;
    for (auto& [unused, triangles] : pieces)
        found.push_back(std::move(triangles));
    return found;
}

// Returns orthonormal axes as columns: the first along `a`, the second in the plane of `a` and `b`. Returns
// the world's axes if the two span no plane.
glm::dmat3 axesAlong(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 normal = glm::cross(a, b);
    if (!(glm::length(normal) > 1e-12 * glm::length(a) * glm::length(b))) return glm::dmat3(1.0);
    const glm::dvec3 x = glm::normalize(a), z = glm::normalize(normal);
    return {x, glm::cross(z, x), z};
}

glm::dvec3 sortedSides(const std::vector<glm::dvec3>& corners, const glm::dmat3& axes) {
    const Bounds bounds = boundsOf(corners, glm::dmat4(glm::transpose(axes)));
    glm::dvec3 sides = bounds.max - bounds.min;
    std::sort(&sides.x, &sides.x + 3);
    return sides;
}

// Measures one piece. `corners`: three per triangle, in world orientation.
Part partOf(const std::vector<glm::dvec3>& corners, const glm::dmat3& objectAxes) {
    Part part;
    double largest = 0.0;
    glm::dmat3 triangleAxes(1.0);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        std::array<glm::dvec3, 3> edges{corners[i + 1] - corners[i], corners[i + 2] - corners[i + 1],
                                        corners[i] - corners[i + 2]};
        const double area = 0.5 * glm::length(glm::cross(edges[0], edges[1]));
        part.area += area;
        if (!(area > largest)) continue;
        largest = area;
        // A right-angled triangle is half a rectangle, and its second longest edge is a side of it.
        std::sort(edges.begin(), edges.end(),
                  [](const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a, a) < glm::dot(b, b); });
        triangleAxes = axesAlong(edges[1], edges[0]);
    }
    const auto surface = [](const glm::dvec3& s) { return s[0] * s[1] + s[1] * s[2] + s[2] * s[0]; };
    const glm::dvec3 objectSides = sortedSides(corners, objectAxes);
    const glm::dvec3 triangleSides = sortedSides(corners, triangleAxes);
    part.sides = surface(objectSides) <= surface(triangleSides) ? objectSides : triangleSides;
    return part;
}

}  // namespace

std::vector<Part> connectedParts(const Scene& scene) {
    std::map<int, std::vector<std::vector<Triangle>>> piecesOf;
    std::vector<Part> parts;
    std::vector<glm::dvec3> corners;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const Mesh& mesh = scene.meshes[instance.mesh];
        const auto [pieces, isNew] = piecesOf.try_emplace(instance.mesh);
        if (isNew) pieces->second = connectedTriangles(mesh);
        const glm::dmat3 linear(instance.worldFromObject);
        for (const std::vector<Triangle>& triangles : pieces->second) {
            corners.clear();
            for (const Triangle& triangle : triangles)
                for (const std::uint32_t vertex : triangle)
                    corners.push_back(linear * glm::dvec3(mesh.vertices[vertex].position));
            Part part = partOf(corners, axesAlong(linear[0], linear[1]));
            part.instance = static_cast<int>(i);
            if (part.area > 0.0) parts.push_back(part);
        }
    }
    return parts;
}

}  // namespace vct
