// Finds which surfaces a scene's own lights reach, on the CPU and roughly, which is enough to choose a view.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/first_surfaces.h"
#include "scene/scene.h"

namespace vct {

class LitSurfaces {
  public:
    // The scene's sun and other lights or, if it has none and `emitters` is set, the surfaces that emit.
    LitSurfaces(const Scene& scene, bool emitters);

    bool exists() const { return !sources_.empty(); }
    // True if light reaches this surface.
    bool reaches(const glm::dvec3& pointWorld, const FirstSurfaces::Sample& surface) const;

  private:
    struct Source {
        std::vector<FirstSurfaces> views;  // the surfaces that the light reaches
        double range;                      // metres
        glm::dvec3 axis;                   // spot lights: world space, unit length
        double minCosine;                  // spot lights: of the angle from the axis
    };
    void addAround(const glm::dvec3& eyeWorld);
    void addSun(const Scene& scene, const glm::dvec3& directionToLight);

    std::vector<Source> sources_;
    std::vector<bool> emits_;  // per instance
};

}  // namespace vct
