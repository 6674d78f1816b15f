// The surfaces that are visible from a point in a few hundred directions, which is enough to choose a view.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/triangle_tree.h"

namespace vct {

// A small picture of the first surface in each of `resolution` x `resolution` directions.
struct FirstSurfaces {
    glm::dvec3 eye{0.0};            // world
    glm::dmat3 worldFromView{1.0};  // columns: right, up, back
    double tanHalfWidth = 1, tanHalfHeight = 1;
    int resolution = 0;
    std::vector<FirstSurface> samples;  // row by row, the bottom row first

    FirstSurfaces(const TriangleTree& tree, const glm::dvec3& eyeWorld, const glm::dmat3& axes,
                  double tanWidth, double tanHeight, int directionsPerSide);

    // Direction of a sample in world space. Its component along the view axis is 1, so the distances of
    // samples are depths.
    glm::dvec3 direction(std::size_t sample) const;
    glm::dvec3 position(std::size_t sample) const {  // of the surface, world
        return eye + samples[sample].distance * direction(sample);
    }
    // Solid angle of a sample, in steradians.
    double solidAngle(std::size_t sample) const;
};

// Returns six views of 90 degrees each, which together cover all directions.
std::vector<FirstSurfaces> viewsAround(const TriangleTree& tree, const glm::dvec3& eyeWorld,
                                       int directionsPerSide);

}  // namespace vct
