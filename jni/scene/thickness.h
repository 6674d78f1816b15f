// Measures how thick and how wide the solids of a scene are, with rays through them. They find the thickness
// of walls even if a whole house is one mesh.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace vct {

struct LocalSize {
    int instance = 0;             // index into Scene::instances
    double thickness = HUGE_VAL;  // along the normal, in metres
    // The second-shortest of three sides at right angles, the thickness among them: of a wall its height or
    // length, of a slat or a column its width.
    double width = HUGE_VAL;
};

// Returns the sizes at `count` points that are spread evenly over the surface of the scene at rest. A size
// above `longest` metres is HUGE_VAL, and so is that of a surface without a back side (a sheet).
std::vector<LocalSize> localSizes(const Scene& scene, std::size_t count, double longest);

}  // namespace vct
