#include "engine/volume.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace vct {

namespace {
constexpr double paddingVoxels = 2.5;  // at each end
}

glm::dmat4 Volume::volumeFromWorld() const {
    return glm::translate(glm::scale(glm::dmat4(1.0), glm::dvec3(1.0 / side)), -minWorld);
}

Volume volumeAround(const Bounds& boundsWorld, int grid) {
    const glm::dvec3 extent = boundsWorld.max - boundsWorld.min;
    const double longest = std::max({extent.x, extent.y, extent.z});
    Volume volume;
    volume.grid = grid;
    // A scene without extent (one point) still gets a volume of finite size.
    volume.side = (longest > 0.0 ? longest : 1.0) * grid / (grid - 2.0 * paddingVoxels);
    volume.minWorld = 0.5 * (boundsWorld.min + boundsWorld.max) - 0.5 * volume.side;
    return volume;
}

}  // namespace vct
