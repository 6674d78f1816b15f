// What shadow maps and voxels follow from: where everything that can move is, and the lights.
#pragma once

#include <vector>

#include "engine/placement.h"

namespace vct {

// A light besides the sun.
struct PunctualLightState {
    glm::dmat4 worldFromLight{1.0};
    bool on = true;

    bool operator==(const PunctualLightState& other) const {
        return worldFromLight == other.worldFromLight && on == other.on;
    }
};

struct SceneState {
    std::vector<Placement> placements;
    glm::dvec3 directionToLight{0.0};  // of the sun, world space
    std::vector<PunctualLightState> lights;

    bool operator==(const SceneState& other) const {
        return placements == other.placements && sameLight(other);
    }
    bool operator!=(const SceneState& other) const { return !(*this == other); }
    bool sameLight(const SceneState& other) const {
        return directionToLight == other.directionToLight && lights == other.lights;
    }
};

}  // namespace vct
