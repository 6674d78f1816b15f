// Punctual lights and their shadow maps. The maps are layers of one texture: six for a point light or a wide
// spot, one for any other light. If they are more than VCT_MAX_LIGHT_MAPS, the lights that matter least have
// none and cast no shadows. All maps together take at most 8 MB. shaders/shared/punctual_lights.glsl reads
// them.
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
#include "scene/strongest_lights.h"

namespace vct {

gl::ProgramDescription lightMapProgram(unsigned features);

// The size of lights that have none of their own (PunctualLight::size), for the penumbrae of their soft
// shadows. Only pixels have soft shadows, voxels do not.
struct LightSize {
    double radius = 0.0;               // metres, of point and spot lights
    double directionalAngleDeg = 0.0;  // full opening angle of directional lights
};

class PunctualLights {
  public:
    // `unitLux`: the irradiance that is 1 in shaders, the sun's E. Throws vct::Error if there are more than
    // VCT_MAX_PUNCTUAL_LIGHTS lights.
    PunctualLights(const gl::ShaderLibrary& shaders, const GpuScene& gpuScene, const Scene& scene,
                   const Volume& volume, double unitLux, const LightSize& size);

    // The next update() uses the new size, pose or state.
    void setSize(const LightSize& size);
    void setPose(const Pose& pose);
    void setOn(std::size_t light, bool on) { states_.at(light).on = on; }
    // Replaces a light, or removes it. Indices end at that of the last light that there is room for
    // (Scene::punctualLightRoom).
    void setLight(std::size_t light, const std::optional<PunctualLight>& definition);
    // The present states of all lights.
    const std::vector<PunctualLightState>& states() const { return states_; }
    // Positions in volume space with w = 1; for directional lights the direction towards the light and w = 0.
    std::vector<glm::dvec4> positions() const;

    // Draws the shadow maps of the lights that are on if the light, or a dynamic object within its range, has
    // changed.
    void update(const GpuScene& scene, const SceneState& now, bool forceRebuild, StepTimer& timer);
    // Marks all maps as out of date. Call it after a frame that failed.
    void invalidate();
    // Binds lights and maps for shaders that include shared/punctual_lights.glsl.
    void bind() const;

    Resources resources() const;

  private:
    // All that maps depend on, besides the objects.
    struct MapSource {
        PunctualLight::Type type;
        glm::dmat4 worldFromLight;
        double outerConeRad, range;
        int firstMap;

        bool operator==(const MapSource&) const = default;
    };
    struct Light {
        std::optional<PunctualLight> definition;  // absent if there is only room for it
        double measure = 0.0;                     // see LightMeasure
        int maps = 0;                             // 0: it has none
        int firstMap = 0;
        // The source and the placements in range that the maps were drawn for.
        std::optional<MapSource> cachedFor = {};
        std::vector<Placement> cachedPlacements = {};
    };
    void assignMaps();
    int freeMaps(int count) const;
    void upload();
    void placeMaps(const Light& light, const PunctualLightState& state);
    std::vector<Placement> placementsInRange(const Light& light, const PunctualLightState& state,
                                             const std::vector<Placement>& placements) const;
    void drawMaps(const GpuScene& scene, const Light& light,
                  const std::optional<std::vector<Bounds>>& changed);

    LightMeasure measure_;
    std::vector<Light> lights_;
    std::vector<PunctualLightState> states_;
    std::vector<PunctualLightState> uploaded_;
    Volume volume_;
    Bounds boundsWorld_;
    double unitLux_;
    LightSize size_;
    int maps_ = 0;
    int mapSize_ = 0;  // texels along a side of a map
    MaterialPrograms programs_;
    shared::PunctualLightBlock values_{};
    gl::Buffer uniforms_;
    gl::Texture depth_;  // one layer per map
    std::vector<gl::Framebuffer> framebuffers_;
};

// The sun and the punctual lights with their shadow maps.
struct DirectLight {
    ShadowTextures sun;                              // null textures if no output reads them
    const PunctualLights* punctualLights = nullptr;  // null if the sun is the only light

    // Binds everything for the shaders that read it.
    void bind() const {
        sun.bind();
        if (punctualLights != nullptr) punctualLights->bind();
    }
};

}  // namespace vct
