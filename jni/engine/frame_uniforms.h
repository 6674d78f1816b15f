// Fills the uniforms that all passes of a frame share: camera, sun, volume and settings.
#pragma once

#include "engine/cascades.h"
#include "engine/settings.h"
#include "engine/volume.h"
#include "scene/scene.h"
#include "shared/layout.h"

namespace vct {

// Orthographic projection along the light, fitted to the bounds: x, y and depth in [0, 1]. The depth range is
// the diagonal of the bounds for every direction, so that a bias in depth means the same for all of them.
glm::dmat4 shadowFromWorld(const DirectionalLight& light, const Bounds& boundsWorld, int shadowMapSize);

// `radianceUnit`: radianceUnit() of the scene. `visibleWorld` bounds the drawn objects and sets the near and
// far planes (clipFromWorld()).
shared::FrameUniforms frameUniforms(const Camera& camera, const DirectionalLight& light, float radianceUnit,
                                    const Bounds& boundsWorld, const Volume& volume, const Settings& settings,
                                    const Bounds& visibleWorld);
// The same if all objects are within `boundsWorld`.
inline shared::FrameUniforms frameUniforms(const Camera& camera, const DirectionalLight& light,
                                           float radianceUnit, const Bounds& boundsWorld,
                                           const Volume& volume, const Settings& settings) {
    return frameUniforms(camera, light, radianceUnit, boundsWorld, volume, settings, boundsWorld);
}

// The camera's position in volume space.
glm::dvec3 eyeInVolume(const Camera& camera, const Volume& volume);

// Fills the uniforms of cascades: their places in this frame and before the camera moved, and the tiles of
// the shadow map, each of settings.shadowMapSize texels along a side. The last tile shows the whole volume,
// the others the next finer cascades.
void setCascades(shared::FrameUniforms& frame, const Cascades& now, const Cascades& last,
                 const DirectionalLight& light, const Bounds& boundsWorld, const Volume& volume,
                 const Settings& settings);

}  // namespace vct
