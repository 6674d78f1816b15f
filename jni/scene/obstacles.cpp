#include "scene/obstacles.h"

#include <algorithm>
#include <cmath>

namespace vct {

namespace {

constexpr std::size_t maxTrianglesOfLeaf = 4;

// True if the ray enters the box before `longest`.
bool meetsBox(const glm::vec3& min, const glm::vec3& max, const glm::vec3& from, const glm::vec3& inverse,
              float longest) {
    const glm::vec3 a = (min - from) * inverse, b = (max - from) * inverse;
    const glm::vec3 in = glm::min(a, b), out = glm::max(a, b);
    return std::max({in.x, in.y, in.z, 0.0F}) <= std::min({out.x, out.y, out.z, longest});
}

}  // namespace

Obstacles::Obstacles(const Scene& scene) : centre_(0.5 * (scene.boundsWorld.min + scene.boundsWorld.max)) {
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
        if (instance.moves() || material.alphaMode == Material::AlphaMode::mask) continue;
        const bool isMirrored = glm::determinant(glm::dmat3(instance.worldFromObject)) < 0.0;
        const auto corner = [&](std::size_t i) {
            const glm::dvec3 position = mesh.centre + glm::dvec3(mesh.vertices[mesh.indices[i]].position);
            return glm::vec3(glm::dvec3(instance.worldFromObject * glm::dvec4(position, 1.0)) - centre_);
        };
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const glm::vec3 a = corner(i), b = corner(i + (isMirrored ? 2 : 1)),
                            c = corner(i + (isMirrored ? 1 : 2));
            triangles_.push_back({a, b - a, c - a, material.doubleSided});
        }
    }
    if (!triangles_.empty()) build(0, triangles_.size());
}

void Obstacles::build(std::size_t begin, std::size_t end) {
    const std::size_t self = nodes_.size();
    nodes_.push_back({glm::vec3(HUGE_VALF), glm::vec3(-HUGE_VALF), static_cast<std::uint32_t>(begin),
                      static_cast<std::uint32_t>(end - begin)});
    for (std::size_t i = begin; i < end; ++i) {
        const Triangle& t = triangles_[i];
        for (const glm::vec3& corner : {t.corner, t.corner + t.edge1, t.corner + t.edge2}) {
            nodes_[self].min = glm::min(nodes_[self].min, corner);
            nodes_[self].max = glm::max(nodes_[self].max, corner);
        }
    }
    if (end - begin <= maxTrianglesOfLeaf) return;
    const glm::vec3 sides = nodes_[self].max - nodes_[self].min;
    const int axis = sides.x >= sides.y && sides.x >= sides.z ? 0 : sides.y >= sides.z ? 1 : 2;
    const auto at = [axis](const Triangle& t) {
        return 3.0F * t.corner[axis] + t.edge1[axis] + t.edge2[axis];
    };
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(triangles_.begin() + static_cast<std::ptrdiff_t>(begin),
                     triangles_.begin() + static_cast<std::ptrdiff_t>(middle),
                     triangles_.begin() + static_cast<std::ptrdiff_t>(end),
                     [&](const Triangle& a, const Triangle& b) { return at(a) < at(b); });
    build(begin, middle);
    nodes_[self].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[self].count = 0;
    build(middle, end);
}

std::optional<Obstacles::Hit> Obstacles::first(const glm::dvec3& fromWorld, const glm::dvec3& directionWorld,
                                               double longest) const {
    const glm::vec3 from(fromWorld - centre_), direction(directionWorld);
    const glm::vec3 inverse = 1.0F / direction;
    auto nearest = static_cast<float>(longest);
    std::optional<Hit> found;
    std::vector<std::uint32_t> open;
    if (!nodes_.empty()) open.push_back(0);
    while (!open.empty()) {
        const std::uint32_t index = open.back();
        const Node& node = nodes_[index];
        open.pop_back();
        if (!meetsBox(node.min, node.max, from, inverse, nearest)) continue;
        if (node.count == 0) {
            open.push_back(node.first);
            open.push_back(index + 1);
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            // Möller and Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection".
            const Triangle& t = triangles_[i];
            const glm::vec3 p = glm::cross(direction, t.edge2);
            const float determinant = glm::dot(t.edge1, p);  // above 0 if the ray meets the front
            if (determinant == 0.0F || (determinant < 0.0F && !t.doubleSided)) continue;
            const glm::vec3 offset = from - t.corner;
            const float u = glm::dot(offset, p) / determinant;
            const glm::vec3 q = glm::cross(offset, t.edge1);
            const float v = glm::dot(direction, q) / determinant;
            const float distance = glm::dot(t.edge2, q) / determinant;
            if (u < 0.0F || v < 0.0F || u + v > 1.0F || distance <= 0.0F || distance > nearest) continue;
            nearest = distance;
            const glm::dvec3 front = glm::normalize(glm::dvec3(glm::cross(t.edge1, t.edge2)));
            found = Hit{distance, determinant > 0.0F ? front : -front};
        }
    }
    return found;
}

}  // namespace vct
