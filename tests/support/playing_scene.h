// An animated scene with a renderer, and its comparison with a fresh renderer of the same pose.
#pragma once

#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/moving_scenes.h"
#include "support/renderers.h"

namespace vct::test {

class PlayingScene {
  public:
    // The scene must live as long.
    PlayingScene(const Context& context, const Scene& scene, const Settings& settings,
                 std::shared_ptr<gl::ProgramCache> programs = {})
        : scene_(scene),
          renderer_(makeRenderer(context, scene, chooseLight(scene), settings, std::move(programs))) {}

    void frameAt(double seconds, Output mode = Output::gi);
    // Draws two frames: where dynamic objects need more capacity, a frame after the GPU has finished adds it.
    void drawTwiceAt(double seconds, Output mode = Output::gi);
    // Draws a frame with converged irradiance.
    void convergedAt(double seconds, Output mode = Output::gi);
    void frame(Output mode = Output::gi) { renderer_.render({{mode}, chooseCamera(scene_, "")}); }
    Renderer& renderer() { return renderer_; }

  private:
    Camera moveTo(double seconds);
    const Scene& scene_;
    Renderer renderer_;
};

// Draws a frame and expects the grid of a fresh renderer of a static scene. Pictures are compared unless they
// show irradiance, whose history has earlier poses.
void expectFresh(PlayingScene& stage, const Context& context, const Scene& scene, const Settings& settings,
                 double seconds, Output mode = Output::gi);

// Expects the converged irradiance of a fresh renderer, apart from noise of the last directions and of 8
// bits.
void expectFreshLight(PlayingScene& stage, const Context& context, const Scene& scene,
                      const Settings& settings, double seconds, Output mode = Output::gi);

}  // namespace vct::test
