// The irradiance of the directional voxels' faces: a few cones gather light for each face in each step, and a
// history keeps the mean, so that pixels only look it up, and nothing is computed once nothing changes.
#pragma once

#include <optional>

#include "engine/directional/directional_voxels.h"
#include "engine/directional/gather_schedule.h"
#include "engine/passes/g_buffer.h"
#include "engine/programs.h"

namespace vct {

// No bounce passes on more than this share of its light: the scene's largest albedo, and at most 0.95, as a
// closed room where nothing is absorbed would have no bound.
float largestBounceShare(const Scene& scene);

// `name`: carry_over, clear_bricks, place_bricks, mark_lookups, choose_faces, light_blocks or fill_bricks.
gl::ProgramDescription lightProgram(const std::string& name, const LightFeatures& sources);
gl::ProgramDescription gatherProgram(const GatherSettings& settings, GatherPurpose of,
                                     const LightFeatures& sources);
gl::ProgramDescription emittersProgram(const GatherSettings& settings, const LightFeatures& sources);
// Ambient visibility depends on no light.
LightFeatures featuresFor(GatherPurpose of, const LightFeatures& sources);

class Irradiance {
  public:
    // `lightFrames`: steps after a change until the light has converged.
    Irradiance(const gl::ShaderLibrary& shaders, const GatherSettings& settings, GatherPurpose of,
               int lightFrames, bool dynamicObjects, const LightFeatures& sources);

    // Says what has happened to the voxels since the last step.
    void onVoxelsChanged(const GatherSchedule::Change& change);
    // The next steps begin as the first ones did.
    void invalidate();

    // Whether another step would change nothing.
    bool isConverged() const { return schedule_.isConverged() && !pending_.any(); }
    // A step begins: makes room, and new faces take over the history of others. Light is to be injected next.
    // `allBounces`: faces send on what they received before; else they send their own light alone, and
    // the first bounce is found.
    void beginStep(const DirectionalVoxels& voxels, bool allBounces);
    // The step ends: faces trace their cones, towards compact emitters too. `surface`: what pixels show,
    // whose faces gather first.
    void gather(const DirectionalVoxels& voxels, const GBuffer::Targets& surface);
    // The number of the step, which seeds the dither of what it stores.
    std::uint32_t frameIndex() const { return step_.frame; }

    // For shaders/directional/irradiance.glsl; null before the first step.
    const gl::Texture* irradiance() const { return irradiance_ ? &*irradiance_ : nullptr; }
    const gl::Texture* bricks() const { return bricks_ ? &*bricks_ : nullptr; }

    // The history of each face, by its id: shaders/directional/face_irradiance.glsl.
    const gl::Buffer& faceIrradiance() const { return faceIrradiance_; }
    // Words of each face in it: two more if the scene has compact emitters.
    std::uint32_t wordsOfFace() const { return emitters_ ? 6 : 4; }
    std::vector<const gl::Texture*> textures() const;

    // For shaders of a step.
    void bind(const DirectionalVoxels& voxels) const;

  private:
    // In each step a quarter of the faces trace cones to the emitters again
    // (shaders/directional/emitters.comp).
    static constexpr int emitterUpdatePeriod = 4;

    void reserveBricks(int grid, std::uint32_t count);
    void reserveFaces(std::uint32_t ids, std::uint32_t bricks);
    void uploadUniforms(bool allBounces) const;
    void placeBricks(const DirectionalVoxels& voxels) const;
    void chooseFaces(const DirectionalVoxels& voxels, const GBuffer::Targets& surface) const;

    GatherSettings settings_;
    GatherSchedule schedule_;
    GatherSchedule::Change pending_;  // since the last step
    gl::Program clearBricks_, placeBricks_, markLookups_, chooseFaces_, gather_, gatherBlocks_, fillBricks_;
    std::optional<gl::Program> carryOver_;    // where there are dynamic objects
    std::optional<gl::Program> emitters_;     // where the scene has compact emitters
    int emitterSteps_ = emitterUpdatePeriod;  // until all faces have traced cones to the emitters again
    bool placesBricks_ = true;                // in the next step
    gl::Buffer uniforms_, faceIrradiance_;
    std::optional<gl::Buffer> visibilityRange_;  // in place of the light's range, for ambient visibility
    std::optional<gl::Texture> irradiance_, bricks_, blockLight_, lastLookups_;
    glm::ivec3 irradianceSize_{0};
    std::uint32_t idCapacity_ = 0, brickCapacity_ = 0, bricksAlong_ = 0;
    GatherStep step_;
};

}  // namespace vct
