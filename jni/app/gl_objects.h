// All GL objects of the app. They are destroyed with the context.
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
    // Makes the objects in the current context. If the driver lacks something that the renderer needs,
    // missing() names it, and only the panel can be drawn.
    explicit GlObjects(const gl::ReadShader& shaders);

    const gl::Capabilities& capabilities() const { return capabilities_; }
    const std::string& missing() const { return missing_; }
    HudRenderer& hud() { return *hud_; }
    Presenter& presenter() { return *presenter_; }

    // The programs of all renderers, and of the self-test.
    const std::shared_ptr<gl::ProgramCache>& programs() const { return programs_; }
    // Links one program that a frame needs and that has not been linked, so that the renderer does not link
    // all of them in one frame. Returns how many there were; 0: the frame can be drawn. Throws vct::Error.
    std::size_t linkNext(const SceneFeatures& features, const Settings& settings, Output mode);

    // Returns the grids that the driver and the free memory allow. Counts the memory of the current renderer
    // as free, because it is destroyed before a new one is made.
    std::vector<int> possibleGrids(const Settings& settings) const;
    // Returns a renderer for the scene and its settings, with the preset and the lights of `choices`.
    // Rebuilds it only if they require that. Throws vct::Error, and then there is no renderer.
    // `baked`: bytes of baked light, which a new renderer uses if they are of this scene and these settings.
    Renderer& rendererFor(const std::shared_ptr<const Scene>& scene, const DirectionalLight& light,
                          const Settings& settings, const Choices& choices,
                          const std::vector<unsigned char>& baked);
    Renderer* renderer() { return renderer_ ? &*renderer_ : nullptr; }
    // The renderer of this scene, or null.
    const Renderer* rendererOf(const std::shared_ptr<const Scene>& scene) const {
        return renderer_ && scene == scene_ ? &*renderer_ : nullptr;
    }
    void dropRenderer();
    // Frees what can be made again and frames of this mode do not need.
    void dropCaches(Output mode);

  private:
    gl::ReadShader shaders_;
    gl::Capabilities capabilities_;
    std::string missing_;
    std::shared_ptr<gl::ProgramCache> programs_ = std::make_shared<gl::ProgramCache>();
    std::optional<HudRenderer> hud_;
    std::optional<Presenter> presenter_;
    std::optional<Renderer> renderer_;
    // Scene and preset that renderer_ was made for.
    std::shared_ptr<const Scene> scene_;
    std::string preset_;
};

}  // namespace vct::app
