// Chooses a camera for a scene that has none, and recognizes scenes that are rooms.
#pragma once

#include "scene/scene.h"

namespace vct {

// Returns a camera for a picture of `aspect` (width over height) that shows the whole scene but for the
// ground that it stands on (subjectOf()), at rest and in its animation, as large as possible. It looks from
// the front, a little from the right and from above, or from another side if much more lit surface is visible
// from there. In a closed room, in a room with windows that has no light, and in a room whose light does not
// reach its outside, it looks from the inside, from the place and in the direction in which most of the
// room's lit volume is visible. It is never inside an object. cameraOption() reproduces the camera exactly.
Camera frameScene(const Scene& scene, double aspect);

// True if the scene is a room seen from inside, closed or open at a side, and not objects in the open.
bool isOpenRoom(const Scene& scene);

}  // namespace vct
