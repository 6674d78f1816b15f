// Chooses among punctual lights if a scene has more of them than a renderer can draw, or than have room for
// shadow maps.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace vct {

// The measure of a light is the illuminance of a surface that faces it at the nearest side of the box around
// an object, without shadows, cones and motion. Lights in such a box or near it count as a tenth of the
// scene's largest side away, because otherwise a weak light that touches a wall would precede a strong one in
// the middle of a room. A light whose range ends before that is 0.
class LightMeasure {
  public:
    explicit LightMeasure(const Scene& scene);
    double of(const PunctualLight& light) const;

  private:
    std::vector<Bounds> boxes_;  // around each instance at rest, in world space
    double nearest_;
};

// Keeps the `most` punctual lights that matter most, in their order. Returns the names of the others, or
// their numbers in the list.
std::vector<std::string> keepStrongestLights(Scene& scene, std::size_t most);

// A spot with a wider half angle has six maps like a point light. A single map would spend most of its texels
// on the rim of the cone.
constexpr double widestSpotMapRad = 1.05;
// The number of shadow maps of a light: 1, or the six sides of a cube.
int shadowMapsOf(const PunctualLight& light);

struct MeasuredLight {
    double measure;
    int maps;  // shadow maps that it needs
};
// For each light, true if it has shadow maps: those with the largest measures, as far as `room` maps suffice.
std::vector<bool> lightsWithMaps(const std::vector<MeasuredLight>& lights, int room);
// The names or numbers of the scene's punctual lights that have no shadow maps.
std::vector<std::string> lightsWithoutMaps(const Scene& scene, int room);

}  // namespace vct
