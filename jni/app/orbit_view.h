// The camera that gestures move. It starts exactly as the scene's camera.
#pragma once

#include <optional>

#include "app/touch.h"
#include "scene/scene.h"

namespace vct::app {

class OrbitView {
  public:
    // Starts with `first` if it is given, else with the scene's first camera, else with a view of the whole
    // scene for a picture of `aspect` (width over height).
    OrbitView(const Scene& scene, const std::optional<Camera>& first, double aspect);

    // Follows the scene's animated camera, until a gesture moves the view. A double tap makes it follow
    // again.
    void follow(const Camera& camera);

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
    void orbit(double yawRad, double pitchRad);

    void start(const Camera& camera);
    void reset();

    glm::dvec3 centre_;  // centre of the scene
    double size_;        // diagonal of the scene, metres
    Camera start_, now_;
    double startDistance_, distance_;  // metres from the eye to the point that the view turns around
    bool moved_ = false;               // a gesture has moved the view
};

}  // namespace vct::app
