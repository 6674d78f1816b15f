// Sorts a mesh's triangles by their dominant axis. One draw call per axis can then voxelize them with a
// vertex shader alone (thesis algorithm 7 without its geometry shader).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace vct {

struct AxisSort {
    // Triangles along x, then y, then z, each group in the mesh's order. Triangles without area are left out.
    std::vector<std::uint32_t> indices;
    std::array<int, 3> indexCounts{};  // indices per axis
};
// `volumeFromObject` is the matrix that the vertex shader multiplies positions by. A triangle's axis can
// depend on how its corners are rounded, so they are transformed exactly as in the shader.
AxisSort sortByAxis(const Mesh& mesh, const glm::mat4& volumeFromObject);

}  // namespace vct
