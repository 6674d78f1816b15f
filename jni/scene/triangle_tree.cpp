#include "scene/triangle_tree.h"

#include <cmath>

namespace vct {

namespace {

constexpr std::size_t maxTrianglesOfLeaf = 4;
constexpr double coincidence = 1e-6;  // greatest difference of two distances of the same place, relative

}  // namespace

glm::dvec3 TriangleTree::Triangle::areaNormal() const {
    const glm::dvec3 a(corners[0]);
    return glm::cross(glm::dvec3(corners[1]) - a, glm::dvec3(corners[2]) - a);
}

TriangleTree::TriangleTree(const Scene& scene, Contents contents)
    : centre_(0.5 * (scene.boundsWorld.min + scene.boundsWorld.max)) {
    for (std::size_t index = 0; index < scene.instances.size(); ++index) {
        const Instance& instance = scene.instances[index];
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
        if (contents == Contents::obstacles &&
            (instance.moves() || material.alphaMode == Material::AlphaMode::mask))
            continue;
        const bool isMirrored = glm::determinant(glm::dmat3(instance.worldFromObject)) < 0.0;
        const auto corner = [&](std::size_t i) {
            const glm::dvec3 position = mesh.centre + glm::dvec3(mesh.vertices[mesh.indices[i]].position);
            return glm::vec3(glm::dvec3(instance.worldFromObject * glm::dvec4(position, 1.0)) - centre_);
        };
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            triangles_.push_back(
                {{corner(i), corner(i + (isMirrored ? 2 : 1)), corner(i + (isMirrored ? 1 : 2))},
                 static_cast<int>(index),
                 material.doubleSided});
    }
    if (!triangles_.empty()) build(0, triangles_.size());
}

void TriangleTree::build(std::size_t begin, std::size_t end) {
    const std::size_t self = nodes_.size();
    nodes_.push_back({glm::vec3(HUGE_VALF), glm::vec3(-HUGE_VALF), static_cast<std::uint32_t>(begin),
                      static_cast<std::uint32_t>(end - begin)});
    for (std::size_t i = begin; i < end; ++i)
        for (const glm::vec3& corner : triangles_[i].corners) {
            nodes_[self].min = glm::min(nodes_[self].min, corner);
            nodes_[self].max = glm::max(nodes_[self].max, corner);
        }
    if (end - begin <= maxTrianglesOfLeaf) return;
    const auto at = [&](std::size_t i) { return triangles_.begin() + static_cast<std::ptrdiff_t>(i); };
    // A ray need not test copies of a triangle.
    if (std::all_of(at(begin), at(end), [&](const Triangle& t) {
            return std::equal(t.corners, t.corners + 3, at(begin)->corners) &&
                   t.isDoubleSided == at(begin)->isDoubleSided;
        })) {
        nodes_[self].count = 1;
        return;
    }
    const glm::vec3 sides = nodes_[self].max - nodes_[self].min;
    const int axis = sides.x >= sides.y && sides.x >= sides.z ? 0 : sides.y >= sides.z ? 1 : 2;
    const auto sum = [axis](const Triangle& t) {
        return t.corners[0][axis] + t.corners[1][axis] + t.corners[2][axis];
    };
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(at(begin), at(middle), at(end),
                     [&](const Triangle& a, const Triangle& b) { return sum(a) < sum(b); });
    build(begin, middle);
    nodes_[self].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[self].count = 0;
    build(middle, end);
}

// Möller and Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection".
double TriangleTree::distanceOf(const Triangle& triangle, const glm::dvec3& from,
                                const glm::dvec3& direction) {
    const glm::dvec3 corner(triangle.corners[0]);
    const glm::dvec3 edge1 = glm::dvec3(triangle.corners[1]) - corner;
    const glm::dvec3 edge2 = glm::dvec3(triangle.corners[2]) - corner;
    const glm::dvec3 p = glm::cross(direction, edge2);
    const double determinant = glm::dot(edge1, p);
    if (determinant == 0.0) return -1.0;
    const glm::dvec3 offset = from - corner;
    const double u = glm::dot(offset, p) / determinant;
    const glm::dvec3 q = glm::cross(offset, edge1);
    const double v = glm::dot(direction, q) / determinant;
    // A ray through an edge meets both triangles beside it.
    constexpr double edge = -1e-9;
    if (u < edge || v < edge || u + v > 1.0 - edge) return -1.0;
    return glm::dot(edge2, q) / determinant;
}

FirstSurface TriangleTree::first(const glm::dvec3& fromWorld, const glm::dvec3& direction,
                                 double longest) const {
    FirstSurface found;
    glm::dvec3 foundNormal(0.0);
    visit(fromWorld, direction, longest, [&](double distance, const Triangle& triangle) {
        const glm::dvec3 normal = triangle.areaNormal();
        const bool isFront = glm::dot(normal, direction) < 0.0;
        if (!isFront && !triangle.isDoubleSided) {
            if (found.backDistance == 0.0 || distance < found.backDistance) found.backDistance = distance;
            return longest;
        }
        const bool isSame = std::abs(found.distance - distance) < coincidence * distance;
        if (found.distance > 0.0 &&
            (isSame ? glm::length(foundNormal) >= glm::length(normal) : found.distance < distance))
            return longest;
        foundNormal = isFront ? normal : -normal;
        found.distance = distance;
        found.instance = triangle.instance;
        longest = std::min(longest, (1.0 + coincidence) * distance);
        return longest;
    });
    if (found.distance > 0.0) {
        found.normal = glm::normalize(foundNormal);
        if (found.backDistance > (1.0 + coincidence) * found.distance) found.backDistance = 0.0;
    }
    return found;
}

}  // namespace vct
