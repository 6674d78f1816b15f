// The state that shadow maps and voxels depend on: placements of the dynamic objects, and the lights.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/placement.h"

namespace vct {

// The changeable part of a punctual light.
struct PunctualLightState {
    glm::dmat4 worldFromLight{1.0};
    bool on = true;

    bool operator==(const PunctualLightState& other) const {
        return worldFromLight == other.worldFromLight && on == other.on;
    }
};

struct SceneState {
    std::vector<Placement> placements;
    glm::dvec3 directionToLight{0.0};  // unit vector towards the sun, world space
    std::vector<PunctualLightState> lights;
    std::uint64_t skyChanges = 0;    // number of changes of the sky
    std::uint64_t lightChanges = 0;  // number of changes of the lights' colours, intensities and the like

    bool operator==(const SceneState& other) const {
        return placements == other.placements && sameLight(other);
    }
    bool operator!=(const SceneState& other) const { return !(*this == other); }
    bool sameLight(const SceneState& other) const {
        return directionToLight == other.directionToLight && lights == other.lights &&
               skyChanges == other.skyChanges && lightChanges == other.lightChanges;
    }
};

}  // namespace vct
