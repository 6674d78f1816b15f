// The camera under the fingers. Starts exactly as the scene's.
#pragma once

#include <optional>

#include "app/touch.h"
#include "scene/scene.h"

namespace vct::app {

class OrbitView {
  public:
    // `first`, else the scene's first camera, else one that sees all of it, in a picture of `aspect` (width
    // over height).
    OrbitView(const Scene& scene, const std::optional<Camera>& first, double aspect);

    // The scene's camera, where an animation has moved it: the view goes with it until fingers move the view,
    // and again after a double tap.
    void follow(const Camera& camera);

    // `viewport`: pixels in which the gesture was made.
    void apply(const Gesture& gesture, glm::ivec2 viewport);

    // By shares of the scene's size to the right, up and back, with the point that is orbited.
    void walk(const glm::dvec3& shares);

    // In a picture of `aspect`. One that is narrower than the scene's camera is made for shows all that it
    // frames: at least a square, or a phone held upright would see a slit.
    Camera camera(double aspect) const;

  private:
    void orbit(double yawRad, double pitchRad);

    void start(const Camera& camera);
    void reset();

    glm::dvec3 centre_;  // the scene's
    double size_;        // its diagonal, metres
    Camera start_, now_;
    double startDistance_, distance_;  // metres from the eye to the point that is orbited
    bool moved_ = false;               // by fingers
};

}  // namespace vct::app
