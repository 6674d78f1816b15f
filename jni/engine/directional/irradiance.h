// Light that lives on the surfaces: what each face of the directional voxels receives, gathered by a few
// cones in each step and remembered, so that pixels only look it up, and nothing is computed once nothing
// changes.
#pragma once

#include <optional>

#include "engine/directional/directional_mipmapper.h"
#include "engine/programs.h"

namespace vct {

// No bounce passes on more than this share of its light: the scene's largest albedo, and at most 0.95, as a
// closed room where nothing is absorbed would have no bound.
float largestBounceShare(const Scene& scene);

// `name`: light_inherit, light_clear, light_bricks, light_blocks or light_shine.
gl::ProgramDescription lightProgram(const std::string& name, const LightFeatures& sources);
gl::ProgramDescription irradianceProgram(const GatherSettings& settings, GatherOf of,
                                         const LightFeatures& sources);
gl::ProgramDescription emittersProgram(const GatherSettings& settings);
// How open the surroundings are depends on no light.
LightFeatures featuresFor(GatherOf of, const LightFeatures& sources);

class Irradiance {
  public:
    // `lightFrames`: steps after a change until the light stands still. `voxelsChange`: others are occupied
    // from frame to frame.
    Irradiance(const gl::ShaderLibrary& shaders, const GatherSettings& settings, GatherOf of, int lightFrames,
               bool voxelsChange, const LightFeatures& sources);

    // What happened to the voxels since the last step:
    struct Change {
        // where their lists were made anew, how many of the base level's faces, the first ones, kept their
        // places;
        std::optional<std::uint32_t> keptFaces;
        bool light = false;  // whether what they send, or what is in the way of it, has changed
    };
    void note(const Change& change);
    // The next steps begin as the first ones did.
    void forget();

    // Whether another step would change nothing.
    bool settled() const { return stepsLeft_ == 0 && !firstNew_; }
    // Every face's mean comes a step nearer to what the face receives. `allBounces`: faces send on what they
    // received before; else they shine with their own light alone, and the first bounce is found.
    void step(DirectionalVoxels& voxels, DirectionalMipmapper& mipmapper, bool allBounces);

    // For shaders/directional/irradiance.glsl; null before the first step.
    const gl::Texture* irradiance() const { return irradiance_ ? &*irradiance_ : nullptr; }
    const gl::Texture* bricks() const { return bricks_ ? &*bricks_ : nullptr; }

    // What each face received, in the order of the base level's list of faces:
    // shaders/directional/received.glsl.
    const gl::Buffer& received() const { return received_; }
    // Of each face in received(): two more where the scene has lamps.
    std::uint32_t wordsOfFace() const { return emitters_ ? 6 : 4; }
    std::vector<const gl::Texture*> textures() const;

  private:
    // How many steps a round has, in which each face looks into all directions once.
    int round() const { return settings_.directions / settings_.cones; }
    // How many cones each face traces in the next step.
    int cones() const { return changed_ ? 1 : settings_.cones; }
    // Which step of a round the next one is, or -1.
    int stepOfRound() const;
    float shareOfStep() const;
    void makeRoomForBricks(int grid, std::uint32_t count);
    void makeRoomForFaces(std::uint32_t faces, std::uint32_t blocks);
    void uploadUniforms(bool allBounces) const;
    void bind(const DirectionalVoxels& voxels) const;
    void placeBricks(const DirectionalVoxels& voxels) const;

    GatherSettings settings_;
    int lightFrames_;
    bool voxelsChange_;
    gl::Program inherit_, clear_, placeBricks_, gather_, gatherBlocks_;
    std::optional<gl::Program> shine_;     // of light
    std::optional<gl::Program> emitters_;  // likewise, where the scene has lamps
    int emitterSteps_ = 0;                 // until all faces have looked at them anew
    gl::Buffer uniforms_, received_;
    std::optional<gl::Texture> irradiance_, bricks_, blockLight_;
    glm::ivec3 irradianceSize_{0};
    std::vector<shared::LevelCommands> counts_;
    std::uint32_t facePlaces_ = 0, blockPlaces_ = 0, brickPlaces_ = 0, bricksAlong_ = 0;
    std::uint32_t frame_ = 0, direction_ = 0;
    bool changed_ = false;  // since the last step
    bool settling_ = true;  // nothing had changed before it
    int stepsLeft_ = 0;
    float age_ = 0.0F;        // steps that the means remember
    float lastShare_ = 0.0F;  // of the last step in them
    float smoothing_ = 0.0F;  // how much of a face's light may be its block's
    std::optional<std::uint32_t>
        firstNew_;  // of faces that have no memory of their own since the lists changed
};

}  // namespace vct
