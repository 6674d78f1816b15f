// The position and size of the voxel cube in the world. In volume space the cube is [0, 1]^3, with the
// world's axes.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace vct {

struct Volume {
    glm::dvec3 minWorld{0.0};
    double side = 1.0;  // metres
    int grid = 256;     // voxels along the side

    glm::dmat4 volumeFromWorld() const;
    double voxelSize() const { return side / grid; }  // metres
};

// The cube around the bounds, with 2.5 empty voxels at each end of the longest extent. The padding keeps
// rounded fragments inside. The half voxel puts a wall on the bounds in the middle of its voxels, where
// rounding cannot move it into the next ones.
Volume volumeAround(const Bounds& boundsWorld, int grid);

}  // namespace vct
