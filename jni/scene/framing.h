// What a scene shows: a room or things, and a view of it where it has no camera of its own.
#pragma once

#include "scene/scene.h"

namespace vct {

// A camera for a picture of `aspect` (width over height) that sees the whole scene, at rest and in its
// animation, as large as the picture has room for: from the front, a little to the right and above; or from
// another side, where much more of its surface is seen from there. A closed room is seen from inside: from
// where, and towards where, most of its space is before the camera. cameraOption() repeats it exactly.
Camera frameScene(const Scene& scene, double aspect);

// Whether the scene is a room that one looks into, closed or open at a side, rather than things in the open.
bool isOpenRoom(const Scene& scene);

}  // namespace vct
