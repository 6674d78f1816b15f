// The camera that gestures move. It starts exactly as the scene's camera.
#pragma once

#include <memory>
#include <optional>

#include "app/touch.h"
#include "scene/scene.h"
#include "scene/triangle_tree.h"

namespace vct::app {

class OrbitView {
  public:
    // Starts with `first` if it is given, else with the scene's first camera, else with a view of the whole
    // scene for a picture of `aspect` (width over height). Gestures do not pass the obstacles, if there are
    // any.
    OrbitView(const Scene& scene, const std::optional<Camera>& first, double aspect,
              std::shared_ptr<const TriangleTree> obstacles = nullptr);

    // Follows the scene's animated camera, until a gesture moves the view. A double tap makes it follow
    // again.
    void follow(const Camera& camera);

    // One finger turns the view around the scene, or around the eye if that is among obstacles: in a room or
    // in a street. Two fingers move and zoom it as if they held the surface that they touched.
    // `viewport`: size of the window in which the gesture was made, in pixels.
    void apply(const Gesture& gesture, glm::ivec2 viewport);

    // Moves the camera, and the point that it turns around, to the right, up and back, in shares of the
    // scene's size.
    void walk(const glm::dvec3& shares);

    // Returns the camera for a picture of `aspect`. If the picture is narrower than the camera is made for,
    // the field of view is widened to show the same width, so that a phone held upright does not show a
    // narrow strip.
    Camera camera(double aspect) const;

  private:
    void begin(const glm::vec2& position, glm::ivec2 viewport);
    bool isAmongObstacles() const;
    void orbit(const glm::dvec3& target, double yawRad, double pitchRad);
    // Returns the part of a step of the eye that obstacles allow. It slides along them.
    glm::dvec3 freePart(const glm::dvec3& eye, glm::dvec3 step) const;

    void start(const Camera& camera);
    void reset();

    glm::dvec3 centre_;  // centre of the scene
    double size_;        // diagonal of the scene, metres
    Camera start_, now_;
    double startDistance_, distance_;  // metres from the eye to the point that the view turns around
    double touchedDepth_;              // metres along the view axis to the surface that two fingers hold
    bool turnsAroundEye_ = false;      // during this gesture
    bool moved_ = false;               // a gesture has moved the view
    std::shared_ptr<const TriangleTree> obstacles_;
};

}  // namespace vct::app
