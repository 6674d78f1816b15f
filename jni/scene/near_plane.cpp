#include "scene/near_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <vector>

#include "scene/camera.h"

namespace vct {
namespace {

// The near plane stays in front of the nearest surface by this factor.
constexpr double clearance = 0.99;
// The view is widened by this factor, because samples of a pixel shift the picture by a part of a pixel.
constexpr double widening = 1.05;

// Positions of an instance's vertices in view space: camera space, with x and y divided by the tangents of
// the half angles, so that the side planes of the view are |x| = depth and |y| = depth, and depth is -z.
class VertexPositions {
  public:
    VertexPositions(const Mesh& mesh, const Instance& instance, const Pose* pose,
                    const glm::dmat4& viewFromWorld)
        : mesh_(mesh) {
        if (mesh.deformation != nullptr) {
            deformation_ = stateOf(*mesh.deformation, pose);
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
    double depth(std::size_t vertex) const {
        const glm::dvec3 position = inMesh(vertex);
        return -(viewFromMesh_[0].z * position.x + viewFromMesh_[1].z * position.y +
                 viewFromMesh_[2].z * position.z + viewFromMesh_[3].z);
    }

  private:
    glm::dvec3 inMesh(std::size_t vertex) const {
        return deformation_ ? deformedVertex(*mesh_.deformation, *deformation_, vertex).positionWorld
                            : glm::dvec3(mesh_.vertices[vertex].position);
    }

    const Mesh& mesh_;
    std::optional<DeformationState> deformation_;
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

Camera withFittedNearPlane(Camera camera, const Scene& scene, double aspect, const Pose* pose) {
    double depth = usualNearPlane(scene.boundsWorld) / clearance;
    if (camera.clipFromWorld || camera.nearest >= clearance * depth) return camera;

    const double tanHalf = widening * std::tan(0.5 * camera.verticalFovRad);
    const glm::dmat4 viewFromWorld =
        glm::scale(glm::dmat4(1.0), 1.0 / glm::dvec3(tanHalf * aspect, tanHalf, 1.0)) *
        glm::inverse(camera.worldFromCamera);
    std::vector<double> depths;  // per vertex
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const VertexPositions positions(mesh, instance, pose, viewFromWorld);
        depths.resize(mesh.vertices.size());
        for (std::size_t i = 0; i < depths.size(); ++i)
            depths[i] = positions.depth(i);
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const std::uint32_t* const index = &mesh.indices[i];
            const auto [nearest, farthest] =
                std::minmax({depths[index[0]], depths[index[1]], depths[index[2]]});
            if (nearest < depth && farthest > 0.0)
                depth = smallestDepth({positions[index[0]], positions[index[1]], positions[index[2]]}, depth);
        }
    }
    camera.nearest = std::max(camera.nearest, clearance * depth);
    return camera;
}

}  // namespace vct
