#include "app/orbit_view.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "scene/camera.h"
#include "scene/framing.h"

namespace vct::app {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double highestRad = 0.49 * pi;  // beyond the vertical, left and right would be exchanged
// Distances in shares of the scene's diagonal.
constexpr double minDistance = 1e-3;  // also the distance that the eye keeps from obstacles
constexpr double maxDistance = 10.0;
// The eye is among obstacles if at least half of this number of level directions end at one.
constexpr int levelDirections = 16;

}  // namespace

OrbitView::OrbitView(const Scene& scene, const std::optional<Camera>& first, double aspect,
                     std::shared_ptr<const TriangleTree> obstacles)
    : centre_(0.5 * (scene.boundsWorld.min + scene.boundsWorld.max)),
      size_(std::max(glm::length(scene.boundsWorld.max - scene.boundsWorld.min), 1e-9)),
      obstacles_(std::move(obstacles)) {
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
    touchedDepth_ = distance_;
    moved_ = false;
}

void OrbitView::begin(const glm::vec2& position, glm::ivec2 viewport) {
    touchedDepth_ = distance_;
    turnsAroundEye_ = isAmongObstacles();
    if (obstacles_ == nullptr) return;
    const glm::dvec2 size(glm::max(viewport, 1));
    const glm::dvec2 at = (2.0 * glm::dvec2(position) / size - 1.0) * glm::dvec2(size.x / size.y, -1.0);
    const double tanHalf = std::tan(0.5 * camera(size.x / size.y).verticalFovRad);
    const glm::dvec3 direction = glm::dmat3(now_.worldFromCamera) * glm::dvec3(at * tanHalf, -1.0);
    const auto hit = obstacles_->first(now_.worldFromCamera[3], direction, maxDistance * size_);
    if (hit.distance > 0.0) touchedDepth_ = hit.distance;
}

bool OrbitView::isAmongObstacles() const {
    if (obstacles_ == nullptr) return false;
    int ends = 0;
    for (int i = 0; i < levelDirections; ++i) {
        const double angle = 2.0 * pi * i / levelDirections;
        const glm::dvec3 level(std::sin(angle), 0.0, std::cos(angle));
        ends += obstacles_->first(now_.worldFromCamera[3], level, size_).distance > 0.0;
    }
    return 2 * ends >= levelDirections;
}

void OrbitView::apply(const Gesture& gesture, glm::ivec2 viewport) {
    if (gesture.doubleTap) return reset();
    if (gesture.begin) begin(*gesture.begin, viewport);
    if (gesture.orbit == glm::vec2(0.0F) && gesture.pan == glm::vec2(0.0F) && gesture.zoom == 1.0F) return;
    moved_ = true;
    const glm::dvec3 before(now_.worldFromCamera[3]);
    const double height = std::max(viewport.y, 1);
    const double verticalFovRad = camera(std::max(viewport.x, 1) / height).verticalFovRad;
    const glm::dvec2 turn(gesture.orbit);
    if (turnsAroundEye_) {
        // The surface below the finger follows it, near the middle of the picture.
        orbit(before, turn.x * verticalFovRad / height, turn.y * verticalFovRad / height);
    } else {
        // Moving a finger over the window's height turns the view by half a turn, like a ball of that
        // diameter.
        orbit(before - distance_ * glm::dvec3(now_.worldFromCamera[2]), -turn.x * pi / height,
              -turn.y * pi / height);
    }
    // The surface that was touched stays under the fingers.
    const double metresPerPixel = 2.0 * touchedDepth_ * std::tan(0.5 * verticalFovRad) / height;
    const glm::dvec3 panned =
        glm::dmat3(now_.worldFromCamera) *
        glm::dvec3(-gesture.pan.x * metresPerPixel, gesture.pan.y * metresPerPixel, 0.0);
    const double depth =
        std::clamp(touchedDepth_ / std::max(gesture.zoom, 1e-3F), minDistance * size_, maxDistance * size_);
    const glm::dvec3 forward(-now_.worldFromCamera[2]);
    const glm::dvec3 turned(now_.worldFromCamera[3]);
    const glm::dvec3 wanted = turned + panned + forward * (touchedDepth_ - depth);
    const glm::dvec3 eye = before + freePart(before, wanted - before);
    now_.worldFromCamera[3] = glm::dvec4(eye, 1.0);
    const double advanced = glm::dot(eye - turned, forward);
    touchedDepth_ = std::max(touchedDepth_ - advanced, minDistance * size_);
    distance_ = std::clamp(distance_ - advanced, minDistance * size_, maxDistance * size_);
}

glm::dvec3 OrbitView::freePart(const glm::dvec3& eye, glm::dvec3 step) const {
    if (obstacles_ == nullptr) return step;
    const double clearance = minDistance * size_;
    constexpr double minSine = 0.1;  // of the angle between step and surface; limits the length of the ray
    glm::dvec3 moved(0.0);
    // A corner of a room has three sides.
    for (int side = 0; side < 3; ++side) {
        const double length = glm::length(step);
        if (length == 0.0) break;
        const glm::dvec3 direction = step / length;
        const auto hit = obstacles_->first(eye + moved, direction, length + clearance / minSine);
        if (hit.distance == 0.0) return moved + step;
        const double sine = std::max(-glm::dot(hit.normal, direction), minSine);
        const double free = std::max(hit.distance - clearance / sine, 0.0);
        if (free >= length) return moved + step;
        moved += free * direction;
        step -= free * direction;
        step -= glm::dot(step, hit.normal) * hit.normal;
    }
    return moved;
}

void OrbitView::walk(const glm::dvec3& shares) {
    moved_ = true;
    now_.worldFromCamera[3] += glm::dvec4(glm::dmat3(now_.worldFromCamera) * (size_ * shares), 0.0);
}

void OrbitView::orbit(const glm::dvec3& target, double yawRad, double pitchRad) {
    if (yawRad == 0.0 && pitchRad == 0.0) return;
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
