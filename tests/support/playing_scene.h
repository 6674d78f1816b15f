// An animated scene on a renderer of its own, at whatever time, and what a renderer leaves that never saw
// another.
#pragma once

#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/moving_scenes.h"
#include "support/renderers.h"

namespace vct::test {

class PlayingScene {
  public:
    // The scene must live as long.
    PlayingScene(const Context& context, const Scene& scene, const Settings& settings)
        : scene_(scene), renderer_(makeRenderer(context, scene, chooseLight(scene), settings)) {}

    void frameAt(double seconds, Output mode = Output::gi);
    // Draws a frame in which the received light is converged.
    // Two frames: where dynamic objects find no room, the frame after one that the GPU has finished makes it.
    void settledAt(double seconds, Output mode = Output::gi);
    void convergedAt(double seconds, Output mode = Output::gi);
    void frame(Output mode = Output::gi) { renderer_.render({{mode}, chooseCamera(scene_, "")}); }
    Renderer& renderer() { return renderer_; }

  private:
    Camera moveTo(double seconds);
    const Scene& scene_;
    Renderer renderer_;
};

// Draws a frame, and expects the grid of a fresh renderer of a scene that stands still there; and its
// picture, where that does not show what faces received: they remember earlier poses.
void expectFresh(PlayingScene& stage, const Context& context, const Scene& scene, const Settings& settings,
                 double seconds, Output mode = Output::gi);

// Expects the same of the converged light that faces received: the difference of the two is noise of the last
// round of directions and of 8 bits, not a trace of where things were.
void expectFreshLight(PlayingScene& stage, const Context& context, const Scene& scene,
                      const Settings& settings, double seconds, Output mode = Output::gi);

}  // namespace vct::test
