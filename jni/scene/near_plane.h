// Fits the near plane of a camera to the surfaces that it sees.
#pragma once

#include "scene/scene.h"

namespace vct {

// Returns the camera with its near plane (Camera::nearest) as far away as it may be without cutting off a
// surface in the picture, but at most at usualNearPlane(). A depth buffer of 24 bits (or of floats between 0
// and 1, which are no finer near 1) resolves positions at distance z to about z^2 2^-24 / near, so with a
// near plane of a millimetre in a room of ten metres positions are off by centimetres, and shadow tests fail.
//
// `aspect` is the picture's width over its height, and `pose` the scene's pose, or null at rest. Takes time
// proportional to the number of vertices, but none if the near plane is far enough already.
Camera withFittedNearPlane(Camera camera, const Scene& scene, double aspect, const Pose* pose = nullptr);

}  // namespace vct
