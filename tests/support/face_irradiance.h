// The irradiance of each face of the directional voxels, read back.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <string>

#include "engine/renderer.h"

namespace vct::test {

struct FaceIrradiance {
    glm::dvec3 light{0.0};  // mean over the hemisphere, relative to E/pi
    double ambientVisibility = 0.0;
    int rays = 0;           // cached rays that have been traced
    bool isHidden = false;  // inside of a solid, so that no pixel sees it
    double coverage = 0.0;  // of the face
    std::array<std::uint32_t, 6> words{};

    bool operator==(const FaceIrradiance& other) const { return words == other.words; }
};

// The key is shared::packFace(voxel, face), so the order of the list does not matter.
using IrradianceByFace = std::map<std::uint32_t, FaceIrradiance>;
IrradianceByFace readIrradiance(const Renderer& renderer);

// The green channel over the faces of both that are not hidden, weighted by coverage as pixels see them.
// `mean` is that of b.
struct IrradianceDifference {
    double mean = 0.0, rms = 0.0, bias = 0.0;
    double largest = 0.0;  // of a face that is covered by a tenth
    std::size_t common = 0;
};
IrradianceDifference differenceOf(const IrradianceByFace& a, const IrradianceByFace& b);

}  // namespace vct::test
