// The light of a scene whose file may bring none.
#pragma once

#include "scene/scene.h"

namespace vct {

// The scene's sun. Where it has none, the default one, of intensity 0 where something in a room glows all
// over, and not by a texture as the dials of an instrument do (in the open, light of that kind shows little
// but itself); but where other lights shine, one of no colour: it gives no light, and its E, which the
// strongest of them gives at a quarter of the scene's size, is the unit of what is drawn.
DirectionalLight chooseLight(const Scene& scene);
// From the upper front right, E = pi.
DirectionalLight defaultLight();
// The radiance of a plain sky for a scene that has no light of its own, so that its first picture shows it;
// else black.
glm::vec3 chooseSky(const Scene& scene);
// The radiance of a sky that gives a floor a quarter of such a light, in the blue of a clear day. As of the
// default light where it gives nothing.
glm::vec3 plainSky(const DirectionalLight& light);

}  // namespace vct
