// Everything of the app that lives in a GL context, and goes with it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/choices.h"
#include "app/hud_renderer.h"
#include "app/presenter.h"
#include "engine/renderer.h"
#include "gl/capabilities.h"

namespace vct::app {

class GlObjects {
  public:
    // In the current context. Where the driver lacks what the pipeline needs, `missing()` says so and only
    // the display can be drawn.
    explicit GlObjects(const gl::ReadShader& shaders);

    const gl::Capabilities& capabilities() const { return capabilities_; }
    const std::string& missing() const { return missing_; }
    const HudRenderer& hud() const { return *hud_; }
    const Presenter& presenter() const { return *presenter_; }

    // The renderer for a scene and its settings, with the preset and the lamps of `choices`; the last one
    // where these need no other. Throws vct::Error, and then there is none.
    // For a renderer in place of the present one, which goes before another comes.
    std::vector<int> possibleGrids(const Settings& settings) const;
    Renderer& rendererFor(const std::shared_ptr<const Scene>& scene, const DirectionalLight& light,
                          const Settings& settings, const Choices& choices);
    Renderer* renderer() { return renderer_ ? &*renderer_ : nullptr; }
    void dropRenderer() { renderer_.reset(); }

  private:
    gl::ReadShader shaders_;
    gl::Capabilities capabilities_;
    std::string missing_;
    std::optional<HudRenderer> hud_;
    std::optional<Presenter> presenter_;
    std::optional<Renderer> renderer_;
    // What renderer_ was made for.
    std::shared_ptr<const Scene> scene_;
    std::string preset_;
};

}  // namespace vct::app
