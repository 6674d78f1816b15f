// Cameras and lights that a command line asks for.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace vct {

// A camera at `eye` that looks at `target`, with `up` upwards in the picture: without it +Y, or +Z where the
// view is straight up or down. Throws vct::Error where eye == target, where up lies along the view, or where
// fov is not in (0, 180) degrees.
Camera lookAt(const glm::dvec3& eye, const glm::dvec3& target, double verticalFovDeg,
              const std::optional<glm::dvec3>& up = {});
// With eye and target rounded to a thousandth to a ten-thousandth of `size`, so that cameraOption() is short
// and gives exactly this camera.
Camera lookAtRounded(const glm::dvec3& eye, const glm::dvec3& target, double verticalFovDeg, double size);

// What --camera takes for a perspective camera: "eye=X,Y,Z,target=X,Y,Z,fov=DEG", and ",up=X,Y,Z" where it is
// not level.
std::string cameraOption(const Camera& camera, const Bounds& boundsWorld);

inline double aspectOf(glm::ivec2 size) {
    return static_cast<double>(size.x) / size.y;
}

// A camera that is made for a picture of another shape, in one of `aspect` (width over height): what it
// frames is seen whole, and more above and below or at its sides.
Camera fitted(Camera camera, double aspect);

// The scene's camera by name or by index ("" takes the first), fitted to a picture of `aspect`; where the
// scene has none, frameScene()'s. Throws vct::Error listing the cameras there are.
Camera chooseCamera(const Scene& scene, const std::string& nameOrIndex, double aspect = 1.0);

// What is to be said of the camera that an option chose in a picture of `aspect`: how the view is repeated
// that a scene without a camera got, or that the picture has another shape than the camera's. One line, or
// "".
std::string cameraNote(const Scene& scene, const std::string& option, const Camera& camera, double aspect);

// Where a camera or a light is in a pose of its scene's animation. One that a scale of zero leaves without an
// orientation keeps that of rest.
Camera posed(Camera camera, const Pose& pose);
DirectionalLight posed(DirectionalLight light, const Pose& pose);
PunctualLight posed(PunctualLight light, const Pose& pose);

// Perspective projection for GL clip space (z in [-1, 1]) with near and far fitted to the scene: to
// `visibleWorld`, which is `boundsWorld` and what has moved out of it. Returns clipFromWorld.
glm::dmat4 clipFromWorld(const Camera& camera, const Bounds& boundsWorld, double aspect,
                         const Bounds& visibleWorld);
inline glm::dmat4 clipFromWorld(const Camera& camera, const Bounds& boundsWorld, double aspect) {
    return clipFromWorld(camera, boundsWorld, aspect, boundsWorld);
}

}  // namespace vct
