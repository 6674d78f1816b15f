// What shadow map and voxels follow from: where everything that can move is, and the sun.
#pragma once

#include <vector>

#include "engine/directional/dirty_blocks.h"

namespace vct {

struct SceneState {
    std::vector<Placement> placements;
    glm::dvec3 towardsLight{0.0};  // world space

    bool operator==(const SceneState& other) const {
        return placements == other.placements && towardsLight == other.towardsLight;
    }
    bool operator!=(const SceneState& other) const { return !(*this == other); }
};

}  // namespace vct
