// The cones of the received light in plain C++ over faces read back from the GPU: what
// shaders/directional/cones.glsl and directional/irradiance.comp must compute.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <vector>

#include "engine/settings.h"
#include "support/faces.h"

namespace vct::test {

// Of a face of the base level, as voxelization leaves it (shaders/directional/face_sums.glsl).
struct FacePlane {
    glm::dvec3 normal{0.0};
    double offset = 0.0;  // of the voxel's middle, along the normal
};
// By the face's entry, as shared::packFace() makes it.
std::map<std::uint32_t, FacePlane> readPlanes(const DirectionalVoxels& voxels);

class CpuFaceCones {
  public:
    // `levels`: the finest first.
    CpuFaceCones(std::vector<FaceLevel> levels, const GatherSettings& settings)
        : levels_(std::move(levels)), settings_(settings) {}

    struct Gathered {
        glm::dvec3 light{0.0};  // mean over the cones, relative to what the faces store as 1
        double sky = 0.0;
    };
    // What a face finds with `cones` of its directions, where its first one is number `direction` (of the
    // step; its own place is added). `face`: its entry, as shared::packFace() makes it.
    // `back`: that of the opposite face of its voxel, if there is one.
    Gathered gather(std::uint32_t face, const FacePlane& plane, const FacePlane* back, int direction,
                    int cones) const;

  private:
    struct Met {
        glm::dvec3 light;  // premultiplied
        double coverage;
    };
    Met sample(const glm::dvec3& positionVoxels, const glm::dvec3& direction, const glm::dvec3& share,
               int level) const;
    glm::dvec4 faceAt(const glm::dvec3& texel, int face, int level) const;
    Gathered trace(const glm::dvec3& start, const glm::dvec3& normal, bool hasBack,
                   const glm::dvec3& direction, double spread) const;

    std::vector<FaceLevel> levels_;
    GatherSettings settings_;
};

}  // namespace vct::test
