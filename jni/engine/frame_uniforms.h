// What every pass of a frame knows: camera, light, volume, settings.
#pragma once

#include "engine/settings.h"
#include "engine/volume.h"
#include "scene/scene.h"
#include "shared/layout.h"

namespace vct {

// Radiance of a lit white surface that faces the light: the unit of everything the shaders compute. 1 where
// there is no light, so that emission alone can still be shown.
float radianceUnit(const DirectionalLight& light);

// Orthographic projection along the light, fitted to the bounds: x, y and depth in [0, 1]. The depth range is
// the length of the bounds' diagonal from every direction, so that the bias means the same for all of them.
glm::dmat4 shadowFromWorld(const DirectionalLight& light, const Bounds& boundsWorld, int shadowMapSize);

// `visibleWorld`: clipFromWorld()'s.
shared::FrameUniforms frameUniforms(const Camera& camera, const DirectionalLight& light,
                                    const Bounds& boundsWorld, const Volume& volume, const Settings& settings,
                                    const Bounds& visibleWorld);
// Where everything is within the bounds.
inline shared::FrameUniforms frameUniforms(const Camera& camera, const DirectionalLight& light,
                                           const Bounds& boundsWorld, const Volume& volume,
                                           const Settings& settings) {
    return frameUniforms(camera, light, boundsWorld, volume, settings, boundsWorld);
}

}  // namespace vct
