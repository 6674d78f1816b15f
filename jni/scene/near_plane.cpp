#include "scene/near_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "scene/camera.h"

namespace vct {
namespace {

// The near plane stays in front of the nearest surface by this factor.
constexpr double clearance = 0.99;
// The view is widened by this factor, because samples of a pixel shift the picture by a part of a pixel.
constexpr double widening = 1.05;
// Three per triangle of a part. Smaller parts have tighter bounds, and more of them are tested.
constexpr std::size_t partIndices = std::size_t{3} * 128;

// Positions of an instance's vertices in view space: camera space, with x and y divided by the tangents of
// the half angles, so that the side planes of the view are |x| = depth and |y| = depth, and depth is -z.
class VertexPositions {
  public:
    VertexPositions(const Mesh& mesh, const Instance& instance, const Pose* pose,
                    const glm::dmat4& viewFromWorld)
        : mesh_(mesh) {
        if (mesh.deformation != nullptr) {
            const DeformationState state = stateOf(*mesh.deformation, pose);
            for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
                deformed_.push_back(deformedVertex(*mesh.deformation, state, i).positionWorld);
            viewFromMesh_ = viewFromWorld;
            return;
        }
        const glm::dmat4& worldFromObject =
            pose != nullptr && instance.node >= 0
                ? pose->worldFromNode.at(static_cast<std::size_t>(instance.node))
                : instance.worldFromObject;
        viewFromMesh_ = viewFromWorld * worldFromObject * glm::translate(glm::dmat4(1.0), mesh.centre);
    }

    glm::dvec3 operator[](std::size_t vertex) const {
        return viewFromMesh_ * glm::dvec4(inMesh(vertex), 1.0);
    }
    // False if nothing in these bounds of the mesh can be in the view at a depth between 0 and `limit`.
    bool mayShow(const Bounds& bounds, double limit) const {
        if (mesh_.deformation != nullptr) return true;  // the bounds are those of the rest pose
        const glm::dvec3 centre = 0.5 * (bounds.min + bounds.max), half = 0.5 * (bounds.max - bounds.min);
        const auto largest = [&](const glm::dvec4& plane) {
            return glm::dot(plane, glm::dvec4(centre, 1.0)) + glm::dot(glm::abs(glm::dvec3(plane)), half);
        };
        const glm::dvec4 x = glm::row(viewFromMesh_, 0), y = glm::row(viewFromMesh_, 1),
                         z = glm::row(viewFromMesh_, 2);
        return largest(z) > -limit && largest(-z) > 0.0 && largest(-z - x) >= 0.0 && largest(-z + x) >= 0.0 &&
               largest(-z - y) >= 0.0 && largest(-z + y) >= 0.0;
    }

  private:
    glm::dvec3 inMesh(std::size_t vertex) const {
        return mesh_.deformation != nullptr ? deformed_[vertex] : glm::dvec3(mesh_.vertices[vertex].position);
    }

    const Mesh& mesh_;
    std::vector<glm::dvec3> deformed_;  // per vertex of a mesh that deforms
    glm::dmat4 viewFromMesh_;
};

// Returns the smallest depth of the part of a triangle that lies between the side planes of the view, or
// `limit` if that is smaller.
double smallestDepth(const std::array<glm::dvec3, 3>& corners, double limit) {
    // Clipping by four planes adds at most four corners (Sutherland and Hodgman 1974).
    std::array<glm::dvec3, 7> polygon{corners[0], corners[1], corners[2]}, clipped;
    std::size_t count = 3;
    for (int plane = 0; plane < 4; ++plane) {
        const auto inside = [plane](const glm::dvec3& p) {
            return -p.z + (plane % 2 == 0 ? p[plane / 2] : -p[plane / 2]);
        };
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % count];
            const double atA = inside(a), atB = inside(b);
            if (atA >= 0.0) clipped[kept++] = a;
            if ((atA >= 0.0) != (atB >= 0.0)) clipped[kept++] = a + (b - a) * (atA / (atA - atB));
        }
        std::swap(polygon, clipped);
        count = kept;
    }
    for (std::size_t i = 0; i < count; ++i)
        limit = std::min(limit, std::max(-polygon[i].z, 0.0));
    return limit;
}

}  // namespace

NearPlane::NearPlane(const Scene& scene) : scene_(scene) {
    for (const Mesh& mesh : scene.meshes) {
        std::vector<Part>& parts = parts_.emplace_back();
        for (std::size_t first = 0; first < mesh.indices.size(); first += partIndices) {
            Part part{first, std::min(first + partIndices, mesh.indices.size()), noBounds};
            for (std::size_t i = part.firstIndex; i < part.lastIndex; ++i)
                part.bounds.include(glm::dvec3(mesh.vertices[mesh.indices[i]].position));
            parts.push_back(part);
        }
    }
}

Camera NearPlane::fitted(Camera camera, double aspect, const Pose* pose) const {
    double depth = usualNearPlane(scene_.boundsWorld) / clearance;
    if (camera.clipFromWorld || camera.nearest >= clearance * depth) return camera;

    const double tanHalf = widening * std::tan(0.5 * camera.verticalFovRad);
    const glm::dmat4 viewFromWorld =
        glm::scale(glm::dmat4(1.0), 1.0 / glm::dvec3(tanHalf * aspect, tanHalf, 1.0)) *
        glm::inverse(camera.worldFromCamera);
    for (const Instance& instance : scene_.instances) {
        const auto index = static_cast<std::size_t>(instance.mesh);
        const Mesh& mesh = scene_.meshes[index];
        const VertexPositions positions(mesh, instance, pose, viewFromWorld);
        for (const Part& part : parts_[index]) {
            if (!positions.mayShow(part.bounds, depth)) continue;
            for (std::size_t i = part.firstIndex; i + 2 < part.lastIndex; i += 3) {
                const std::array<glm::dvec3, 3> corners{positions[mesh.indices[i]],
                                                        positions[mesh.indices[i + 1]],
                                                        positions[mesh.indices[i + 2]]};
                const auto [farthest, nearest] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
                if (-nearest < depth && farthest < 0.0) depth = smallestDepth(corners, depth);
            }
        }
    }
    camera.nearest = std::max(camera.nearest, clearance * depth);
    return camera;
}

}  // namespace vct
