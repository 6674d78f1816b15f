#include "scene/first_surfaces.h"

#include <cmath>

namespace vct {

FirstSurfaces::FirstSurfaces(const TriangleTree& tree, const glm::dvec3& eyeWorld, const glm::dmat3& axes,
                             double tanWidth, double tanHeight, int directionsPerSide)
    : eye(eyeWorld),
      worldFromView(axes),
      tanHalfWidth(tanWidth),
      tanHalfHeight(tanHeight),
      resolution(directionsPerSide),
      samples(static_cast<std::size_t>(directionsPerSide) * directionsPerSide) {
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = tree.first(eye, direction(i));
}

glm::dvec3 FirstSurfaces::direction(std::size_t sample) const {
    const double x = static_cast<double>(sample % resolution), y = static_cast<double>(sample / resolution);
    return worldFromView * glm::dvec3((2.0 * (x + 0.5) / resolution - 1.0) * tanHalfWidth,
                                      (2.0 * (y + 0.5) / resolution - 1.0) * tanHalfHeight, -1.0);
}

double FirstSurfaces::solidAngle(std::size_t sample) const {
    const glm::dvec3 d = direction(sample);
    const double area = 4.0 * tanHalfWidth * tanHalfHeight / (1.0 * resolution * resolution);
    return area / std::pow(glm::dot(d, d), 1.5);
}

std::vector<FirstSurfaces> viewsAround(const TriangleTree& tree, const glm::dvec3& eyeWorld,
                                       int directionsPerSide) {
    const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    std::vector<FirstSurfaces> views;
    for (const glm::dmat3& axes : {glm::dmat3(x, y, z), glm::dmat3(-x, y, -z), glm::dmat3(-z, y, x),
                                   glm::dmat3(z, y, -x), glm::dmat3(x, -z, y), glm::dmat3(x, z, -y)})
        views.emplace_back(tree, eyeWorld, axes, 1.0, 1.0, directionsPerSide);
    return views;
}

}  // namespace vct
