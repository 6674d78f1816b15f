// The unit in which shaders store radiance.
#pragma once

#include "engine/settings.h"
#include "scene/scene.h"

namespace vct {

// E / pi: the radiance of a lit white surface that faces the sun, where E is the sun's illuminance. 0 if the
// sun is off.
float sunlitRadiance(const DirectionalLight& light);

// Returns the radiance that is 1 in shaders, in the scene's unit. It is sunlitRadiance(), or 1 without a sun,
// unless something is so bright that half floats, which end at 65504, could not store it, or unless without a
// sun all lights are so weak that half floats would lose precision.
float radianceUnit(const Scene& scene, const DirectionalLight& light, const Settings& settings);

}  // namespace vct
