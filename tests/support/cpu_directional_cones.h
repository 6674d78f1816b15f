// The cones of a gather in C++, over faces that are read back from the GPU: the same as
// shaders/directional/cones.glsl and gather.comp.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <vector>

#include "engine/settings.h"
#include "support/faces.h"

namespace vct::test {

// The surface of a face of the base level (shaders/directional/face_sums.glsl).
struct FacePlane {
    glm::dvec3 normal{0.0};
    double offset = 0.0;  // from the middle of the voxel along the normal
};
// The key is the face's entry, shared::packFace().
std::map<std::uint32_t, FacePlane> readPlanes(const DirectionalVoxels& voxels);

class CpuFaceCones {
  public:
    // The finest level comes first.
    CpuFaceCones(std::vector<FaceLevel> levels, const GatherSettings& settings)
        : levels_(std::move(levels)), settings_(settings) {}

    struct Gathered {
        glm::dvec3 light{0.0};  // mean over the cones, relative to the radiance that faces store as 1
        double sky = 0.0;
    };
    // The light that a face gathers with `cones` of its directions from number `direction` of the step on.
    // `face`: its entry, shared::packFace(). `back`: the plane of the opposite face of its voxel, if there is
    // one.
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
