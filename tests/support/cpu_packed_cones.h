// The thesis's cone traces in plain C++ over voxels read back from the GPU: what the shader must compute, so
// that an error of the algorithm can be told from an error of the shader. It also counts its steps.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "shared/layout.h"
#include "support/voxels.h"

namespace vct::test {

class CpuConeTracer {
  public:
    // `levels`: every level, the finest first. Of `frame`: towardsLight, skyRadiance, cone and grid.
    CpuConeTracer(std::vector<Words> levels, const shared::FrameUniforms& frame);

    struct Gather {
        glm::dvec3 radiance{0.0};        // relative to E/pi
        double ambientVisibility = 0.0;  // 1 - ambient occlusion
        int steps = 0;                   // of all six cones; each reads one level
    };
    // `reach` in volume sides. 1 for indirect light, the AO distance for occlusion alone.
    Gather gather(const glm::dvec3& positionVolume, const glm::dvec3& normal, double reach) const;

    struct Shadow {
        double light = 1.0;
        int steps = 0;
    };
    Shadow shadow(const glm::dvec3& positionVolume, const glm::dvec3& normal) const;

  private:
    // Radiance and opacity between the eight texels around a point; what lies outside the volume is empty.
    glm::dvec4 sample(const glm::dvec3& positionVolume, int level) const;
    bool seesNothing(const glm::dvec3& positionVolume, int level) const;

    std::vector<Words> levels_;
    shared::FrameUniforms frame_;
    int grid_, lastLevel_;
};

}  // namespace vct::test
