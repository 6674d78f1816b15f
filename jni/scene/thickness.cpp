#include "scene/thickness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>

namespace vct {
namespace {

constexpr double cellsPerSide = 32.0;

struct WorldTriangle {
    glm::dvec3 corner, edge1, edge2;
    glm::dvec3 areaNormal;  // towards the front; its length is twice the area
    std::size_t instance;   // index into Scene::instances
};

// The triangles, relative to the corner of the scene's bounds.
std::vector<WorldTriangle> trianglesOf(const Scene& scene) {
    std::vector<WorldTriangle> triangles;
    for (std::size_t index = 0; index < scene.instances.size(); ++index) {
        const Instance& instance = scene.instances[index];
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const bool isMirrored = glm::determinant(glm::dmat3(instance.worldFromObject)) < 0.0;
        const auto world = [&](std::size_t i) {
            const glm::dvec3 position = mesh.centre + glm::dvec3(mesh.vertices[mesh.indices[i]].position);
            return glm::dvec3(instance.worldFromObject * glm::dvec4(position, 1.0)) - scene.boundsWorld.min;
        };
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const glm::dvec3 a = world(i), b = world(i + 1), c = world(i + 2);
            const glm::dvec3 normal = glm::cross(b - a, c - a);
            if (glm::length(normal) > 0.0)
                triangles.push_back({a, b - a, c - a, isMirrored ? -normal : normal, index});
        }
    }
    return triangles;
}

// Triangles by the cells of a uniform grid that their boxes touch.
class Cells {
  public:
    Cells(const std::vector<WorldTriangle>& triangles, double size) : triangles_(triangles), size_(size) {
        std::size_t entries = 0;
        for (std::uint32_t i = 0; i < triangles.size() && entries <= maxEntries; ++i) {
            const WorldTriangle& t = triangles[i];
            Bounds box{t.corner, t.corner};
            box.include(t.corner + t.edge1);
            box.include(t.corner + t.edge2);
            forEach(box, [&](std::uint32_t cell) {
                cells_[cell].push_back(i);
                ++entries;
            });
        }
        isComplete_ = entries <= maxEntries;
    }

    // False if the triangles are so many and so large that the grid would take too much memory.
    bool isComplete() const { return isComplete_; }

    // Returns the distance at which a ray from inside an instance leaves it, or HUGE_VAL if that is not
    // before `longest`. Only the surfaces of that instance count, because solids of others often overlap it.
    double exit(std::size_t instance, const glm::dvec3& from, const glm::dvec3& direction, double longest) {
        Bounds box{from, from};
        box.include(from + longest * direction);
        candidates_.clear();
        forEach(box, [&](std::uint32_t cell) {
            const auto found = cells_.find(cell);
            if (found != cells_.end())
                candidates_.insert(candidates_.end(), found->second.begin(), found->second.end());
        });
        std::sort(candidates_.begin(), candidates_.end());
        candidates_.erase(std::unique(candidates_.begin(), candidates_.end()), candidates_.end());
        hits_.clear();
        for (const std::uint32_t i : candidates_) {
            if (triangles_[i].instance != instance) continue;
            const std::optional<double> distance = hit(triangles_[i], from, direction);
            // The surface that the ray starts on is not in its way.
            if (distance && *distance > 1e-6 * size_ && *distance <= longest)
                hits_.emplace_back(*distance, glm::dot(triangles_[i].areaNormal, direction) > 0.0 ? -1 : 1);
        }
        std::sort(hits_.begin(), hits_.end());
        int depth = 1;
        for (const auto& [distance, change] : hits_)
            if ((depth += change) == 0) return distance;
        return HUGE_VAL;
    }

  private:
    static constexpr std::size_t maxEntries = std::size_t{1} << 24;

    template <class Visit>
    void forEach(const Bounds& box, Visit visit) const {
        // The scene has at most cellsPerSide cells along a side, and a ray may leave it.
        const glm::ivec3 first(glm::clamp(glm::floor(box.min / size_), 0.0, 255.0));
        const glm::ivec3 last(glm::clamp(glm::floor(box.max / size_), 0.0, 255.0));
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y)
                for (int x = first.x; x <= last.x; ++x)
                    visit(static_cast<std::uint32_t>((z << 16) | (y << 8) | x));
    }

    // Möller and Trumbore 1997, "Fast, Minimum Storage Ray/WorldTriangle Intersection".
    static std::optional<double> hit(const WorldTriangle& t, const glm::dvec3& from,
                                     const glm::dvec3& direction) {
        const glm::dvec3 p = glm::cross(direction, t.edge2);
        const double determinant = glm::dot(t.edge1, p);
        if (determinant == 0.0) return std::nullopt;
        const glm::dvec3 offset = from - t.corner;
        const double u = glm::dot(offset, p) / determinant;
        const glm::dvec3 q = glm::cross(offset, t.edge1);
        const double v = glm::dot(direction, q) / determinant;
        if (u < 0.0 || v < 0.0 || u + v > 1.0) return std::nullopt;
        return glm::dot(t.edge2, q) / determinant;
    }

    const std::vector<WorldTriangle>& triangles_;
    double size_;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> cells_;
    bool isComplete_ = true;
    std::vector<std::uint32_t> candidates_;
    std::vector<std::pair<double, int>>
        hits_;  // distance, and 1 where a solid is entered, -1 where it is left
};

LocalSize sizeAt(Cells& cells, std::size_t instance, const glm::dvec3& point, const glm::dvec3& inwards,
                 double longest) {
    LocalSize size;
    size.thickness = cells.exit(instance, point, inwards, longest);
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
            cells.exit(instance, middle, along, longest) + cells.exit(instance, middle, -along, longest);
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
    const std::vector<WorldTriangle> triangles = trianglesOf(scene);
    double area = 0.0;
    for (const WorldTriangle& triangle : triangles)
        area += glm::length(triangle.areaNormal);
    const glm::dvec3 sides = scene.boundsWorld.max - scene.boundsWorld.min;
    Cells cells(triangles, std::max(longest, std::max({sides.x, sides.y, sides.z}) / cellsPerSide));
    if (!cells.isComplete()) return {};
    std::vector<LocalSize> sizes;
    double passed = 0.0;  // area of the triangles before this one
    for (const WorldTriangle& triangle : triangles) {
        passed += glm::length(triangle.areaNormal);
        while (sizes.size() < count &&
               (static_cast<double>(sizes.size()) + 0.5) * area < passed * static_cast<double>(count)) {
            // Points of the R2 sequence (Roberts 2018), folded into the triangle.
            const auto i = static_cast<double>(sizes.size() + 1);
            glm::dvec2 uv = glm::fract(i * glm::dvec2(0.7548776662466927, 0.5698402909980532));
            if (uv.x + uv.y > 1.0) uv = 1.0 - uv;
            const glm::dvec3 point = triangle.corner + uv.x * triangle.edge1 + uv.y * triangle.edge2;
            sizes.push_back(
                sizeAt(cells, triangle.instance, point, -glm::normalize(triangle.areaNormal), longest));
        }
    }
    return sizes;
}

}  // namespace vct
