// What each face of the directional voxels received, brought to the CPU.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <string>

#include "engine/renderer.h"

namespace vct::test {

struct ReceivedLight {
    glm::dvec3 light{0.0};  // mean over the hemisphere, relative to E/pi; or ambientVisibility
    double steps = 0.0;     // that the mean remembers
    double coverage = 0.0;  // of the face
    std::array<std::uint32_t, 4> words{};

    bool operator==(const ReceivedLight& other) const { return words == other.words; }
};

// By voxel and face, as shared::packFace() packs them: the order of the list does not show.
using ReceivedFaces = std::map<std::uint32_t, ReceivedLight>;
ReceivedFaces readReceived(const Renderer& renderer, GatherPurpose of = GatherPurpose::light);

// Over the faces of both, weighted by their coverage, as pixels see them; the green channel's. `mean` of b.
struct ReceivedDifference {
    double mean = 0.0, rms = 0.0, bias = 0.0;
    double largest = 0.0;  // of a face that is covered by a tenth
    std::size_t common = 0;
};
ReceivedDifference differenceOf(const ReceivedFaces& a, const ReceivedFaces& b);

}  // namespace vct::test
