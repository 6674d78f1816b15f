// A mesh's triangles sorted by the axis along which they are voxelized, so that one vertex shader can project
// all triangles of a draw call (thesis algorithm 7 without its geometry shader).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace vct {

struct AxisSort {
    std::vector<std::uint32_t>
        indices;                       // along x, then y, then z, each in the mesh's order; none without area
    std::array<int, 3> indexCounts{};  // of each axis
};

// `volumeFromObject`: what the vertex shader multiplies positions by. The axes are those that the geometry
// shader finds, bit for bit, whatever the transform: a triangle's axis depends on where it lies as well, by
// the rounding of its corners.
AxisSort sortByAxis(const Mesh& mesh, const glm::mat4& volumeFromObject);

}  // namespace vct
