// What would be seen from a place, found on the CPU in a few hundred directions: enough to choose a view by.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace vct {

// A small picture, of `resolution` x `resolution` directions, of the surfaces that are met first. As in a
// rendered picture, the backs of single-sided triangles are looked through; holes of alpha masks are not. Of
// two triangles that lie in one another, a floor and the underside of what stands on it, the larger is met.
struct FirstSurfaces {
    struct Sample {
        double depth = 0.0;      // along the view axis, world units; 0: nothing is met
        glm::dvec3 normal{0.0};  // world, unit, of the side that is seen
        int instance = -1;       // index into Scene::instances
        double area = 0.0;       // of the triangle, square metres
    };

    glm::dvec3 eye{0.0};            // world
    glm::dmat3 worldFromView{1.0};  // columns: right, up, back
    double tanHalfWidth = 1, tanHalfHeight = 1;
    int resolution = 0;
    std::vector<Sample> samples;  // row by row, the lowest first

    FirstSurfaces(const glm::dvec3& eyeWorld, const glm::dmat3& axes, double tanWidth, double tanHeight,
                  int directionsPerSide);

    // World space, its component along the view axis 1: `eye` + depth times it is on the surface.
    glm::dvec3 direction(std::size_t sample) const;
    // Steradians that a sample stands for.
    double solidAngle(std::size_t sample) const;

    // The corners are counter-clockwise on the front, where `normalWorld`, twice as long as the area is
    // large, points away.
    void draw(const glm::dvec3 (&cornersWorld)[3], const glm::dvec3& normalWorld, bool doubleSided,
              int instance);
};

// Draws the scene, at rest, into each.
void drawFirstSurfaces(const Scene& scene, std::vector<FirstSurfaces>& views);

// Six views of a right angle each, that together see every direction.
std::vector<FirstSurfaces> viewsAround(const glm::dvec3& eyeWorld, int directionsPerSide);

}  // namespace vct
