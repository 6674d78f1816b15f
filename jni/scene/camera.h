// Cameras and lights that a command line asks for.
#pragma once

#include <string>

#include "scene/scene.h"

namespace vct {

// A camera at `eye` that looks at `target`; +Y is up, or +Z where the view is straight up or down.
// Throws vct::Error where eye == target or fov is not in (0, 180) degrees.
Camera lookAt(const glm::dvec3& eye, const glm::dvec3& target, double verticalFovDeg);

// The scene's camera by name or by index ("" takes the first). Throws vct::Error listing the cameras there
// are; where there is none, the message suggests a --camera that frames the scene.
Camera chooseCamera(const Scene& scene, const std::string& nameOrIndex);

// A camera that sees the whole scene from the front and above.
Camera frameScene(const Scene& scene);

// Where a camera or a light is in a pose of its scene's animation. One that a scale of zero leaves without an
// orientation keeps that of rest.
Camera posed(Camera camera, const Pose& pose);
DirectionalLight posed(DirectionalLight light, const Pose& pose);
PunctualLight posed(PunctualLight light, const Pose& pose);

// The scene's sun. Where it has none, the default one, of intensity 0 where something in the scene glows; but
// where other lights shine, one of no colour: it gives no light, and its E, which the strongest of them gives
// at a quarter of the scene's size, is the unit of what is drawn.
DirectionalLight chooseLight(const Scene& scene);
// From the upper front right, E = pi.
DirectionalLight defaultLight();
// The radiance of a plain sky for a scene in which nothing shines, so that its first picture shows it; else
// black.
glm::vec3 chooseSky(const Scene& scene);
// The radiance of a sky that gives a floor a quarter of such a light, in the blue of a clear day. As of the
// default light where it gives nothing.
glm::vec3 plainSky(const DirectionalLight& light);

// Perspective projection for GL clip space (z in [-1, 1]) with near and far fitted to the scene: to
// `visibleWorld`, which is `boundsWorld` and what has moved out of it. Returns clipFromWorld.
glm::dmat4 clipFromWorld(const Camera& camera, const Bounds& boundsWorld, double aspect,
                         const Bounds& visibleWorld);
inline glm::dmat4 clipFromWorld(const Camera& camera, const Bounds& boundsWorld, double aspect) {
    return clipFromWorld(camera, boundsWorld, aspect, boundsWorld);
}

}  // namespace vct
