#include "engine/axis_sort.h"

#include "shared/dominant_axis.h"

namespace vct {

AxisSort sortByAxis(const Mesh& mesh, const glm::mat4& volumeFromObject) {
    std::vector<glm::vec3> positions;
    positions.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices)
        positions.push_back(shared::positionInVolume(volumeFromObject, vertex.position));

    std::array<std::vector<std::uint32_t>, 3> along;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t* corners = &mesh.indices[i];
        const int axis =
            shared::dominantAxis(positions[corners[0]], positions[corners[1]], positions[corners[2]]);
        if (axis != VCT_AXIS_NONE) along[axis].insert(along[axis].end(), corners, corners + 3);
    }

    AxisSort sorted;
    for (std::size_t axis = 0; axis < along.size(); ++axis) {
        sorted.indexCounts[axis] = static_cast<int>(along[axis].size());
        sorted.indices.insert(sorted.indices.end(), along[axis].begin(), along[axis].end());
    }
    return sorted;
}

}  // namespace vct
