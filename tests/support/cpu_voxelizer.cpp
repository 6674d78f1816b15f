#include "support/cpu_voxelizer.h"

#include <algorithm>
#include <cmath>

namespace vct {

namespace {

// Whether the triangle (relative to the cube's centre) and the cube lie apart along `axis`. An axis of length
// zero separates nothing.
bool apartAlong(const glm::dvec3& axis, const glm::dvec3 (&corners)[3], double half) {
    const double a = glm::dot(axis, corners[0]);
    const double b = glm::dot(axis, corners[1]);
    const double c = glm::dot(axis, corners[2]);
    const double reach = half * (std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z));
    return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

void markTriangle(Occupancy& occupied, const glm::dvec3 (&corners)[3], int grid, double marginVoxels) {
    const glm::dvec3 low = glm::min(corners[0], glm::min(corners[1], corners[2])) - marginVoxels;
    const glm::dvec3 high = glm::max(corners[0], glm::max(corners[1], corners[2])) + marginVoxels;
    // One voxel around, because a corner on a face belongs to the voxel before it as well.
    const glm::ivec3 first = glm::clamp(glm::ivec3(glm::floor(low)) - 1, 0, grid - 1);
    const glm::ivec3 last = glm::clamp(glm::ivec3(glm::floor(high)) + 1, 0, grid - 1);
    for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) {
                const std::size_t index = (static_cast<std::size_t>(z) * grid + y) * grid + x;
                if (!occupied[index])
                    occupied[index] =
                        triangleTouchesCube(corners, glm::dvec3(x, y, z) + 0.5, 0.5 + marginVoxels);
            }
}

}  // namespace

// The separating axis test of Akenine-Moeller 2001, "Fast 3D Triangle-Box Overlap Testing": two convex bodies
// lie apart only if they do along a face normal of either or a cross product of two of their edges.
bool triangleTouchesCube(const glm::dvec3 (&corners)[3], const glm::dvec3& centre, double half) {
    const glm::dvec3 v[3] = {corners[0] - centre, corners[1] - centre, corners[2] - centre};
    const glm::dvec3 edges[3] = {v[1] - v[0], v[2] - v[1], v[0] - v[2]};
    if (apartAlong(glm::cross(edges[0], edges[1]), v, half)) return false;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0.0);
        axis[i] = 1.0;
        if (apartAlong(axis, v, half)) return false;
        for (const glm::dvec3& edge : edges)
            if (apartAlong(glm::cross(axis, edge), v, half)) return false;
    }
    return true;
}

Occupancy occupancyOnCpu(const Scene& scene, const Volume& volume, double marginVoxels,
                         const std::function<bool(const Material&)>& counts) {
    const auto side = static_cast<std::size_t>(volume.grid);
    Occupancy occupied(side * side * side, false);
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        if (!counts(scene.materials[mesh.material])) continue;
        std::vector<glm::dvec3> voxelPositions;
        for (const Vertex& vertex : mesh.vertices) {
            const glm::dvec3 object = mesh.centre + glm::dvec3(vertex.position);
            const glm::dvec3 world(instance.worldFromObject * glm::dvec4(object, 1.0));
            voxelPositions.push_back((world - volume.minWorld) / volume.voxelSize());
        }
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const glm::dvec3 corners[3] = {voxelPositions[mesh.indices[i]],
                                           voxelPositions[mesh.indices[i + 1]],
                                           voxelPositions[mesh.indices[i + 2]]};
            // A triangle without area is no surface: nothing is to be seen of it.
            if (glm::cross(corners[1] - corners[0], corners[2] - corners[0]) == glm::dvec3(0.0)) continue;
            markTriangle(occupied, corners, volume.grid, marginVoxels);
        }
    }
    return occupied;
}

}  // namespace vct
