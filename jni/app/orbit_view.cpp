#include "app/orbit_view.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/camera.h"
#include "scene/framing.h"

namespace vct::app {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double highestRad = 0.49 * pi;  // beyond the vertical, left and right would be exchanged

}  // namespace

OrbitView::OrbitView(const Scene& scene, const std::optional<Camera>& first, double aspect)
    : centre_(0.5 * (scene.boundsWorld.min + scene.boundsWorld.max)),
      size_(std::max(glm::length(scene.boundsWorld.max - scene.boundsWorld.min), 1e-9)) {
    if (!first && !scene.cameras.empty()) {
        start(scene.cameras.front());
    } else {
        Camera fitting = first ? *first : frameScene(scene, aspect);
        fitting.aspectRatio = aspect;
        start(fitting);
    }
    reset();
}

void OrbitView::follow(const Camera& camera) {
    start(camera);
    if (!moved_) reset();
}

void OrbitView::start(const Camera& camera) {
    start_ = camera;
    if (!start_.aspectRatio) start_.aspectRatio = 1.0;
    const glm::dvec3 eye(camera.worldFromCamera[3]);
    const glm::dvec3 forward(-camera.worldFromCamera[2]);
    // The view turns around the point of the view axis nearest to the scene's centre, or around a point close
    // to the camera if it looks away from the scene.
    startDistance_ = std::max(glm::dot(centre_ - eye, forward), 0.1 * size_);
}

void OrbitView::reset() {
    now_ = start_;
    distance_ = startDistance_;
    moved_ = false;
}

void OrbitView::apply(const Gesture& gesture, glm::ivec2 viewport) {
    if (gesture.doubleTap) return reset();
    if (gesture.orbit == glm::vec2(0.0F) && gesture.pan == glm::vec2(0.0F) && gesture.zoom == 1.0F) return;
    moved_ = true;
    const double height = std::max(viewport.y, 1);
    // Moving a finger over the window's height turns the view by half a turn, like a ball of that diameter.
    orbit(-gesture.orbit.x * pi / height, -gesture.orbit.y * pi / height);
    // The point that the view turns around stays under the fingers.
    const double verticalFovRad = camera(std::max(viewport.x, 1) / height).verticalFovRad;
    const double metresPerPixel = 2.0 * distance_ * std::tan(0.5 * verticalFovRad) / height;
    const glm::dvec3 moved = glm::dmat3(now_.worldFromCamera) *
                             glm::dvec3(-gesture.pan.x * metresPerPixel, gesture.pan.y * metresPerPixel, 0.0);
    const double distance = std::clamp(distance_ / std::max(gesture.zoom, 1e-3F), 1e-3 * size_, 10.0 * size_);
    const glm::dvec3 forward(-now_.worldFromCamera[2]);
    now_.worldFromCamera[3] += glm::dvec4(moved + forward * (distance_ - distance), 0.0);
    distance_ = distance;
}

void OrbitView::walk(const glm::dvec3& shares) {
    moved_ = true;
    now_.worldFromCamera[3] += glm::dvec4(glm::dmat3(now_.worldFromCamera) * (size_ * shares), 0.0);
}

void OrbitView::orbit(double yawRad, double pitchRad) {
    if (yawRad == 0.0 && pitchRad == 0.0) return;
    const glm::dvec3 target =
        glm::dvec3(now_.worldFromCamera[3]) - distance_ * glm::dvec3(now_.worldFromCamera[2]);
    // The elevation is the eye's height above the target, as an angle. Positive pitch lowers the eye, because
    // the scene follows the finger.
    const double elevation = std::asin(std::clamp(now_.worldFromCamera[2].y, -1.0, 1.0));
    // A scene's camera may look straight down.
    const double limit = std::max(highestRad, std::abs(elevation));
    const double pitch = elevation - std::clamp(elevation - pitchRad, -limit, limit);
    const glm::dvec3 right(now_.worldFromCamera[0]);
    glm::dmat4 turn = glm::translate(glm::dmat4(1.0), target);
    turn = glm::rotate(turn, yawRad, glm::dvec3(0.0, 1.0, 0.0));
    turn = glm::rotate(turn, pitch, right);
    now_.worldFromCamera = glm::translate(turn, -target) * now_.worldFromCamera;
    // Orthonormalizes the axes, because rounding errors of many turns would add up.
    glm::dvec3 z = glm::normalize(glm::dvec3(now_.worldFromCamera[2]));
    glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(now_.worldFromCamera[1]), z));
    now_.worldFromCamera[0] = glm::dvec4(x, 0.0);
    now_.worldFromCamera[1] = glm::dvec4(glm::cross(z, x), 0.0);
    now_.worldFromCamera[2] = glm::dvec4(z, 0.0);
}

Camera OrbitView::camera(double aspect) const {
    return fitted(now_, aspect);
}

}  // namespace vct::app
