// Lights besides the sun, and their shadow maps: layers of one texture, six for a point, one for a spot or a
// directional light. shaders/shared/punctual_lights.glsl reads them.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/gpu_scene.h"
#include "engine/passes/shadow_map.h"
#include "engine/resource.h"
#include "engine/scene_state.h"
#include "engine/step_timer.h"
#include "gl/objects.h"

namespace vct {

gl::ProgramDescription lightMapProgram(unsigned features);

// Of the lights, which their maps do not show: pixels' shadows alone have penumbrae.
struct LightSize {
    double radius = 0.0;  // of points and spots, in the scene's unit
    double directionalAngleDeg = 0.0;
};

class PunctualLights {
  public:
    // `unitLux`: irradiance that is 1 in shaders, the sun's E. Throws vct::Error where there are more lights
    // than there is room for.
    PunctualLights(const gl::ShaderLibrary& shaders, const GpuScene& scene,
                   const std::vector<PunctualLight>& lights, const Volume& volume, const Bounds& boundsWorld,
                   double unitLux, const LightSize& size);

    // For frames to come.
    void setSize(const LightSize& size);
    // Moves those that move, in frames to come.
    void setPose(const Pose& pose);
    // Switches one on or off, in frames to come.
    void setOn(std::size_t light, bool on) { states_.at(light).on = on; }
    // Of all, as they are now.
    const std::vector<PunctualLightState>& states() const { return states_; }
    // Where each is, in volume space; for a directional one the direction towards it, and w 0.
    std::vector<glm::dvec4> positions() const;

    // Draws the maps of those lights that have changed, or in whose reach something has.
    void update(const GpuScene& scene, const SceneState& now, bool forceRebuild, StepTimer& timer);
    // The next update draws all maps: a frame failed, so they may be wrong.
    void invalidate();
    // For shaders that include shared/punctual_lights.glsl.
    void bind() const;

    Resources resources() const;

  private:
    struct Light {
        PunctualLight definition;
        bool usesCube;
        int firstMap;
        // The state that its maps show, and the placements in its reach.
        std::optional<PunctualLightState> cachedFor;
        std::vector<Placement> cachedPlacements;
    };
    void upload();
    void placeMaps(const Light& light, const PunctualLightState& state);
    std::vector<Placement> inReach(const Light& light, const PunctualLightState& state,
                                   const std::vector<Placement>& placements) const;
    void drawMaps(const GpuScene& scene, const Light& light);

    std::vector<Light> lights_;
    std::vector<PunctualLightState> states_;
    std::vector<PunctualLightState> uploaded_;
    Volume volume_;
    Bounds boundsWorld_;
    double unitLux_;
    LightSize size_;
    int maps_ = 0;
    int mapSize_ = 0;  // texels along a side of each
    MaterialPrograms programs_;
    shared::PunctualLightBlock values_{};
    gl::Buffer uniforms_;
    gl::Texture depth_;  // a layer for each map
    std::vector<gl::Framebuffer> framebuffers_;
};

// The light that reaches surfaces straight from its sources, with the maps for its shadows.
struct DirectLight {
    ShadowTextures sun;                              // null if the picture does not read them
    const PunctualLights* punctualLights = nullptr;  // null if the sun is the only light

    // Binds all of it for the shaders that read it.
    void bind() const {
        sun.bind();
        if (punctualLights != nullptr) punctualLights->bind();
    }
};

}  // namespace vct
