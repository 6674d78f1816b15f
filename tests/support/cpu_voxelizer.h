// Which voxels a scene's triangles touch, exactly and in double: what the GPU's rasterizer approximates.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "engine/volume.h"
#include "scene/scene.h"

namespace vct {

// Whether a triangle and the cube centre +- half share a point; touching counts.
bool triangleTouchesCube(const glm::dvec3 (&corners)[3], const glm::dvec3& centre, double half);

using Occupancy = std::vector<bool>;  // x fastest, then y, then z

// Voxels whose cube, grown by `marginVoxels` on each side (shrunk where negative), touches a triangle of a
// material that `counts`. A triangle on the face between two voxels touches both, and rounding decides which
// of them a GPU takes; a small margin of either sign says what it must and what it may take.
Occupancy occupancyOnCpu(const Scene& scene, const Volume& volume, double marginVoxels,
                         const std::function<bool(const Material&)>& counts);

}  // namespace vct
