// The cube of voxels in the world. Volume space is [0, 1]^3 with the world's axes.
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

// The cube around the bounds with 2.5 empty voxels on each side of the longest extent: no fragment falls
// outside through rounding, and a wall on the bounds lies in the middle of its voxels, where no driver's
// rounding can move it into the next ones.
Volume volumeAround(const Bounds& boundsWorld, int grid);

}  // namespace vct
