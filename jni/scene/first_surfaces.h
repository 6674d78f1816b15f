// Finds the surfaces that are visible from a point, on the CPU and in a few hundred directions, which is
// enough to choose a view.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace vct {

// A small picture of the first surface in each of `resolution` x `resolution` directions. As in a rendered
// picture, the back of a single-sided triangle is invisible; holes of alpha masks are ignored. Of two
// coinciding triangles (a floor, and the underside of an object on it) the larger one counts.
struct FirstSurfaces {
    struct Sample {
        double depth = 0.0;      // along the view axis, world units; 0: no surface
        glm::dvec3 normal{0.0};  // world space, unit length, on the visible side
        int instance = -1;       // index into Scene::instances
        double area = 0.0;       // area of the triangle, square metres
        double backDepth = 0.0;  // depth of the first back that is invisible, if findsBacks; 0: none
    };

    glm::dvec3 eye{0.0};            // world
    glm::dmat3 worldFromView{1.0};  // columns: right, up, back
    double tanHalfWidth = 1, tanHalfHeight = 1;
    int resolution = 0;
    bool findsBacks = false;
    std::vector<Sample> samples;  // row by row, the bottom row first

    FirstSurfaces(const glm::dvec3& eyeWorld, const glm::dmat3& axes, double tanWidth, double tanHeight,
                  int directionsPerSide);

    // Direction of a sample in world space. Its component along the view axis is 1, so eye + depth *
    // direction lies on the surface.
    glm::dvec3 direction(std::size_t sample) const;
    // Solid angle of a sample, in steradians.
    double solidAngle(std::size_t sample) const;

    // Draws a triangle. Its corners are counter-clockwise seen from the front. `normalWorld` points away from
    // the front, and its length is twice the triangle's area.
    void draw(const glm::dvec3 (&cornersWorld)[3], const glm::dvec3& normalWorld, bool doubleSided,
              int instance);
};

// Draws the scene in its rest pose into each view.
void drawFirstSurfaces(const Scene& scene, std::vector<FirstSurfaces>& views);

// Returns six views of 90 degrees each, which together cover all directions.
std::vector<FirstSurfaces> viewsAround(const glm::dvec3& eyeWorld, int directionsPerSide);

}  // namespace vct
