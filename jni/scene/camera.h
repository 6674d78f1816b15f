// Choosing, posing and projecting cameras; posing lights.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace vct {

// Returns a camera at `eye` that looks at `target`, with `up` pointing upwards in the picture. The default of
// `up` is +Y, or +Z if the view is straight up or down. Throws vct::Error if eye == target, if `up` is
// parallel to the view direction, or if the field of view is not in (0, 180) degrees.
Camera lookAt(const glm::dvec3& eye, const glm::dvec3& target, double verticalFovDeg,
              const std::optional<glm::dvec3>& up = {});
// As lookAt(), with eye and target rounded to a thousandth to a ten-thousandth of `size`, so that
// cameraOption() is short and reproduces the camera exactly.
Camera lookAtRounded(const glm::dvec3& eye, const glm::dvec3& target, double verticalFovDeg, double size);

// Text of the option --camera for a camera: "eye=X,Y,Z,target=X,Y,Z,fov=DEG", and ",up=X,Y,Z" if it is not
// level.
std::string cameraOption(const Camera& camera, const Bounds& boundsWorld);

inline double aspectOf(glm::ivec2 size) {
    return static_cast<double>(size.x) / size.y;
}

// Fits a camera to a picture of `aspect` (width over height). If the camera is made for another aspect ratio,
// the picture shows everything that the camera frames, and more above and below or at the sides.
Camera fitted(Camera camera, double aspect);

// Returns the scene's camera with this name or index ("": the first), fitted to a picture of `aspect`. If the
// scene has no camera and none is asked for, returns that of frameScene(). Throws vct::Error listing the
// scene's cameras.
Camera chooseCamera(const Scene& scene, const std::string& nameOrIndex, double aspect = 1.0);

// Returns a note for the user, one line, if the scene has no camera (how to reproduce the chosen view) or if
// the picture's `aspect` differs from that of the camera. `option` is the text of --camera. Returns "" if
// there is nothing to note.
std::string cameraNote(const Scene& scene, const std::string& option, const Camera& camera, double aspect);

// Returns the camera or light in a pose of its scene's animation. If a scale of zero leaves it without an
// orientation, it keeps that of the rest pose.
Camera posed(Camera camera, const Pose& pose);
DirectionalLight posed(DirectionalLight light, const Pose& pose);
PunctualLight posed(PunctualLight light, const Pose& pose);

// Returns the largest distance of the near plane of a camera inside a scene of this size, in world units: a
// thousandth of the diagonal.
double usualNearPlane(const Bounds& boundsWorld);

// Returns the view and projection matrix for GL clip space (z in [-1, 1]). Near and far plane are fitted to
// `visibleWorld`, which contains `boundsWorld` and everything that has moved out of it.
glm::dmat4 clipFromWorld(const Camera& camera, const Bounds& boundsWorld, double aspect,
                         const Bounds& visibleWorld);
inline glm::dmat4 clipFromWorld(const Camera& camera, const Bounds& boundsWorld, double aspect) {
    return clipFromWorld(camera, boundsWorld, aspect, boundsWorld);
}

}  // namespace vct
