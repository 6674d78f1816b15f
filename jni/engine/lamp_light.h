// How bright lights besides the sun, and lamps, make a scene's surfaces, found by rays on the CPU when the
// scene is loaded.
#pragma once

#include "engine/emitters.h"

namespace vct {

// What the lights of a scene besides the sun and its lamps make of it: the radiance of its brightest
// surfaces, were they white, but for spots beside a lamp that are too small to count; and the flux that they
// send, over pi. Scene's units.
struct LampLight {
    double brightest = 0.0;
    double fluxOverPi = 0.0;
};
LampLight lampLight(const Scene& scene, const std::vector<EmitterPart>& emitters, double voxelSize);

}  // namespace vct
