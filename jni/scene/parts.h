// The connected pieces of a scene's geometry and how large they are: a slat, a column, a wall.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace vct {

struct Part {
    int instance = 0;       // index into Scene::instances
    glm::dvec3 sides{0.0};  // of a box around it, in metres, the shortest first
    double area = 0.0;      // of its triangles, in square metres; above 0
};

// Triangles of one instance that share corners make a part. Its box lies along the axes of its object or
// along its largest triangle, whichever is the smaller one: exact for what is made of boxes and
// cylinders. What is bent, or welded into one piece with others, counts with the box around all of it.
std::vector<Part> connectedParts(const Scene& scene);

}  // namespace vct
