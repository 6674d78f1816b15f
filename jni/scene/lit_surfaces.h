// Finds which surfaces a scene's own lights reach, which is enough to choose a view.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"
#include "scene/triangle_tree.h"

namespace vct {

class LitSurfaces {
  public:
    // The scene's sun and other lights or, if it has none and `emitters` is set, the surfaces that emit. The
    // tree must outlive this object.
    LitSurfaces(const Scene& scene, const TriangleTree& tree, bool emitters);

    bool exists() const { return !sources_.empty(); }
    // True if light reaches this surface.
    bool reaches(const glm::dvec3& pointWorld, const FirstSurface& surface) const;

  private:
    struct Source {
        glm::dvec3 position;  // world; of a sun, relative to the surface
        bool isSun = false;
        bool isEmitter = false;   // its centre may lie behind its own surface
        double range = HUGE_VAL;  // metres
        glm::dvec3 axis{0.0};     // spot lights: world space, unit length
        double minCosine = -1.0;  // spot lights: of the angle from the axis
    };
    const TriangleTree& tree_;
    std::vector<Source> sources_;
    std::vector<bool> emits_;  // per instance
};

}  // namespace vct
