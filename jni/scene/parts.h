// Finds the connected pieces of a scene's geometry (a slat, a column, a wall) and their sizes.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace vct {

struct Part {
    int instance = 0;       // index into Scene::instances
    glm::dvec3 sides{0.0};  // sides of a box around the part, in metres, the shortest first
    double area = 0.0;      // area of its triangles, in square metres; above 0
};

// Returns the parts of a scene: triangles of one instance that share corners. The box of a part is aligned
// with the axes of its object or with its largest triangle, whichever box is smaller. That is exact for boxes
// and cylinders. A bent part, or one that is joined with others, counts with the box around all of it.
std::vector<Part> connectedParts(const Scene& scene);

}  // namespace vct
