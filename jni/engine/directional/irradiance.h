// The irradiance of the directional voxels' faces. In each light step faces trace a few cones, and each face
// keeps a running mean over its steps, its history. Pixels look the mean up. Once all means have converged,
// steps are skipped until something changes.
#pragma once

#include <optional>

#include "engine/directional/directional_voxels.h"
#include "engine/directional/gather_schedule.h"
#include "engine/passes/g_buffer.h"
#include "engine/programs.h"

namespace vct {

// The largest share of light that the balance (shaders/directional/light_balance.glsl) lets a bounce reflect:
// the scene's largest albedo, limited to 0.95, because without absorption the light in a closed room would
// grow without bound.
float largestBounceShare(const Scene& scene);

// A program of a light step, except for the gather and the emitters. `name`: carry_over, clear_bricks,
// place_bricks, mark_walls, mark_lookups, choose_faces, light_blocks or fill_bricks.
gl::ProgramDescription lightProgram(const std::string& name, const LightFeatures& sources);
gl::ProgramDescription gatherProgram(const GatherSettings& settings, const LightFeatures& sources);
gl::ProgramDescription emittersProgram(const LightFeatures& sources);

class Irradiance {
  public:
    // `lightFrames`: as in GatherSchedule. `listsChange`: there are dynamic objects or cascades.
    Irradiance(const gl::ShaderLibrary& shaders, const GatherSettings& settings, int lightFrames,
               bool listsChange, const LightFeatures& sources);

    // Reports a change of the voxels, which the next step takes into account.
    void onVoxelsChanged(const GatherSchedule::Change& change);
    // Makes the next step start without histories.
    void invalidate();

    // True if another step would change nothing.
    bool isConverged() const { return schedule_.isConverged() && !pending_.any(); }

    // Begins a step: reserves buffers. After a new pose, faces of dynamic objects first take over the
    // histories of faces of the previous pose. Then chooses the faces that gather: if the step has a budget
    // of rays, faces that the pixels of the G-buffer `surface` look up gather more often than others
    // (shaders/directional/gather_turns.glsl). The caller injects light next. `allBounces`: faces also
    // reflect their irradiance; false: the first bounce only.
    void beginStep(const DirectionalVoxels& voxels, const GBuffer::Targets& surface, bool allBounces);
    // Ends the step: faces gather, and trace rays towards the compact emitters.
    void gather(const DirectionalVoxels& voxels);
    // True if fillBricks() would change something.
    bool isOutdated(bool visibility) const {
        return outdated_ != Outdated::none || showsVisibility_ != visibility;
    }
    // Brings the bricks up to date: with light, or with ambient visibility.
    void fillBricks(const DirectionalVoxels& voxels, bool visibility);
    // False while only cascades move: then the passes visit the active faces alone
    // (shaders/directional/active_faces.glsl).
    bool visitsAll() const { return step_.longEnough == 0.0F; }
    // Dispatches one invocation per face, or a fixed number of them, which loop over a list of faces.
    void dispatchOverFaces(const DirectionalVoxels& voxels, bool all) const;

    // True if the bricks have light, and not ambient visibility.
    bool holdsLight() const { return irradiance_ && !showsVisibility_; }
    // The textures for shaders/directional/irradiance.glsl; null before the first step. irradiance(): the
    // bricks themselves. bricks(): for each block and direction, the place of its brick.
    const gl::Texture* irradiance() const { return irradiance_ ? &*irradiance_ : nullptr; }
    const gl::Texture* bricks() const { return bricks_ ? &*bricks_ : nullptr; }
    // The thin walls across the bricks: shaders/directional/walls.glsl.
    const gl::Texture* walls() const { return walls_ ? &*walls_ : nullptr; }
    // The histories by face id: shaders/directional/face_irradiance.glsl.
    const gl::Buffer& faceIrradiance() const { return faceIrradiance_; }
    // Words per face in faceIrradiance(): five, and two more for the light of compact emitters.
    std::uint32_t irradianceWords() const { return emitters_ ? 7 : 5; }
    std::vector<const gl::Texture*> textures() const;
    // Binds the buffers and textures that the shaders of a step use.
    void bind(const DirectionalVoxels& voxels) const;

  private:
    void reserveBricks(const DirectionalVoxels& voxels, std::uint32_t count);
    void reserveFaces(const DirectionalVoxels& voxels);
    void uploadUniforms(bool allBounces) const;
    // Gives the faces of a list the histories of the last list of its pair.
    void carryOver(const DirectionalVoxels& voxels, std::uint32_t list) const;
    // `moved`: the cascades whose static walls have changed, a bit for each.
    void placeBricks(const DirectionalVoxels& voxels, std::uint32_t moved) const;
    // Marks the walls of a list's faces in a texture of their words.
    void markWalls(const DirectionalVoxels& voxels, std::uint32_t list, const gl::Texture& words,
                   std::uint32_t cascades) const;
    void chooseFaces(const DirectionalVoxels& voxels, const GBuffer::Targets& surface) const;

    GatherSettings settings_;
    GatherSchedule schedule_;
    GatherSchedule::Change pending_;  // changes that no step has taken into account yet
    gl::Program clearBricks_, placeBricks_, markWalls_, markLookups_, chooseFaces_, gather_, lightBlocks_,
        fillBricks_;
    std::optional<gl::Program> carryOver_;  // only with dynamic objects or cascades
    std::optional<gl::Program> emitters_;   // only if the scene has compact emitters
    // Steps left in which faces trace rays towards emitters: all of them, or those with a short history. At
    // first, all have none and one step is enough.
    int emitterSteps_ = 0, newEmitterSteps_ = 1;
    bool placesBricks_ = true;   // the next step has to place the bricks
    bool marksAllWalls_ = true;  // the next step has to mark all static walls
    // The bricks that are out of date: none, those of the active faces, or all.
    enum class Outdated { none, active, all } outdated_ = Outdated::all;
    bool showsVisibility_ = false;  // the bricks have ambient visibility
    gl::Buffer uniforms_, faceIrradiance_;
    std::optional<gl::Texture> irradiance_, bricks_, walls_, staticWalls_, blockLight_, lastLookups_;
    glm::ivec3 irradianceSize_{0};
    FaceCapacities capacities_{};  // of the lists whose faces faceIrradiance_ has room for
    std::uint32_t idCapacity_ = 0, brickCapacity_ = 0, bricksAlong_ = 0;
    GatherStep step_;
};

}  // namespace vct
