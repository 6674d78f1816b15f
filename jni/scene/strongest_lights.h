// Chooses among punctual lights if a scene has more of them than a renderer can draw.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace vct {

// Keeps the `most` punctual lights that matter most, in their order. Returns the names of the others, or
// their numbers in the list.
//
// The measure of a light is the illuminance of a surface that faces it at the nearest side of the box around
// an object, without shadows, cones and motion. Lights in such a box or near it count as a tenth of the
// scene's largest side away, because otherwise a weak light that touches a wall would precede a strong one in
// the middle of a room. A light whose range ends before that is 0.
std::vector<std::string> keepStrongestLights(Scene& scene, std::size_t most);

}  // namespace vct
