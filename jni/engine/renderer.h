// The frame: shadow map, G-buffer, voxels, mip levels, cones. Read frame() in renderer.cpp first.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/directional/directional_voxelizer.h"
#include "engine/directional/incremental_update.h"
#include "engine/directional/irradiance.h"
#include "engine/directional/relighter.h"
#include "engine/gpu_scene.h"
#include "engine/packed/packed_mipmapper.h"
#include "engine/packed/packed_voxelizer.h"
#include "engine/passes/g_buffer.h"
#include "engine/passes/shade.h"
#include "engine/passes/shadow_map.h"
#include "engine/settings.h"
#include "gl/capabilities.h"
#include "gl/program.h"
#include "image/image.h"
#include "lab/step_timer.h"

namespace vct {

// The same picture by other means where the driver lacks what `settings` would use.
Settings forDriver(Settings settings, const gl::Capabilities& capabilities);

class Renderer {
  public:
    // Throws vct::Error where the settings are out of range or the driver has not the memory. Passes that no
    // mode asks for are never made.
    Renderer(const Scene& scene, const DirectionalLight& light, const Settings& settings,
             const gl::Capabilities& capabilities, gl::ReadShader readShader);

    // Draws one frame. While neither light nor pose changes, shadow map and voxels stay as they are; where
    // only the light does, voxels are lit anew. What the surfaces receive comes one step nearer to its final
    // value, and stands still Settings::lightFrames frames after the last change. With Settings::revoxelize
    // everything is made. Throws vct::Error on any GL error; the next frame then makes everything anew.
    void frame(Mode mode, const Camera& camera);
    // Likewise, when all those steps are done: a still picture.
    void renderConverged(Mode mode, const Camera& camera);

    // Of frames to come: where what moves is. What the pose does to cameras and lights, posed() says.
    void setPose(const Pose& pose) { nextPose_ = pose; }
    // Likewise. The light's strength stays as it was, as emission is stored relative to it.
    void setLightDirection(const glm::dvec3& towardsLight);
    // Likewise; full opening angle. Throws vct::Error where it is out of range.
    void setShadowConeAngle(float degrees);

    // The last frame as the cones left it: RGBA16F, relative to radianceScale(), row 0 at the bottom.
    const gl::Texture& output() const { return shade_.texture(); }
    float radianceScale() const;

    // The last frame, linear RGB in the scene's radiance unit, row 0 at the top.
    Image radiance() const;

    struct DebugView {
        std::string name;  // "g_buffer_albedo": a file name without its ending
        Image image;       // linear RGB, scaled for the eye
        bool hasUnits;     // false: made for the eye only, no use as data
    };
    // What the cones saw, each alone, drawn anew from `camera` when the light stands still:
    // ambient_occlusion, indirect_light (of one bounce), cone_shadow.
    std::vector<DebugView> lightParts(const Camera& camera);
    // Every intermediate, the light parts among them, drawn anew from `camera`.
    std::vector<DebugView> debugViews(const Camera& camera);

    // Active voxels per level, empty if no mode needed voxels yet. Throws vct::Error where
    // the list overflowed.
    std::vector<std::uint32_t> activeVoxels() const;

    struct Resource {
        std::string name;
        std::size_t bytes;
    };
    std::vector<Resource> resources() const;

    StepTimer& timer() { return timer_; }
    const Volume& volume() const { return volume_; }
    // Null until a mode needed voxels, and where they are of the other kind.
    VoxelPyramid* voxels() { return packedPasses_ ? &packedPasses_->pyramid : nullptr; }
    DirectionalVoxels* directionalVoxels() {
        return directionalPasses_ ? &directionalPasses_->voxels : nullptr;
    }

    // Null until a mode needed what the faces receive.
    const Irradiance* received(GatherOf of) const {
        if (!directionalPasses_) return nullptr;
        const std::optional<Irradiance>& pass =
            of == GatherOf::light ? directionalPasses_->light : directionalPasses_->occlusion;
        return pass ? &*pass : nullptr;
    }

  private:
    struct PackedPasses {
        VoxelPyramid pyramid;
        PackedVoxelizer voxelizer;
        PackedMipmapper mipmapper;
    };
    struct DirectionalPasses {
        DirectionalVoxels voxels;
        DirectionalVoxelizer voxelizer;
        DirectionalMipmapper mipmapper;
        std::optional<IncrementalUpdate> partial;  // where something moves
        std::optional<Relighter> relighter;
        std::optional<Irradiance> light, occlusion;
    };
    // What shadow map and voxels follow from: where what moves is, and the light.
    struct Lit {
        std::vector<Placement> placements;
        glm::dvec3 towardsLight;

        bool operator==(const Lit& other) const {
            return placements == other.placements && towardsLight == other.towardsLight;
        }
        bool operator!=(const Lit& other) const { return !(*this == other); }
    };
    // Of what the last ones were made; nothing: they were not.
    struct Made {
        std::optional<Lit> shadowMap, voxels;
        bool shadowLevels = false;
        bool allBounces = true;  // in the received light
    };
    // `lightSteps`: of the received light, at most. `allBounces`: or the first one alone.
    void draw(int modeOrView, const Camera& camera, int lightSteps, bool allBounces = true);
    ShadowMap& shadowMap();
    PackedPasses& packedPasses();
    DirectionalPasses& directionalPasses();
    Irradiance& irradiance(int modeOrView);
    const VoxelPyramid& occupancy();
    void uploadFrameUniforms(const Camera& camera);
    void updatePacked();
    void updateDirectional(const std::optional<Lit>& before, const Lit& now);
    std::optional<BlockMask> changedSince(const std::optional<Lit>& before) const;
    Image view(int view, const Camera& camera, bool allBounces);

    Settings settings_;
    bool texturesInMainMemory_;
    gl::ShaderLibrary shaders_;
    DirectionalLight light_;
    Bounds boundsWorld_;
    std::size_t triangles_;
    float faceRadianceRange_, largestBounceShare_;
    Volume volume_;
    GpuScene scene_;
    std::optional<Pose> nextPose_;
    gl::Buffer frameUniforms_;
    GBuffer gBuffer_;
    Shade shade_;
    std::optional<ShadowMap> shadowMap_;
    std::optional<PackedPasses> packedPasses_;
    std::optional<DirectionalPasses> directionalPasses_;
    Made made_;
    StepTimer timer_;
};

}  // namespace vct
