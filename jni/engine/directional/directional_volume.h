// Directional voxels, six faces each, and the light that the faces receive: a pixel only looks it up.
#pragma once

#include <optional>

#include "engine/directional/incremental_update.h"
#include "engine/directional/irradiance.h"
#include "engine/directional/relighter.h"
#include "engine/volume.h"
#include "engine/voxel_volume.h"

namespace vct {

class DirectionalVolume final : public VoxelVolume {
  public:
    // `boundsWorld`: around the scene, as the shadow map is fitted to them. `sources`: all that shine.
    DirectionalVolume(const gl::ShaderLibrary& shaders, const GpuScene& scene, const Settings& settings,
                      const Volume& volume, const Bounds& boundsWorld, const LightFeatures& sources);

    // Of another light the voxels are lit anew; of another pose, only the blocks that what moves, or its
    // shadow, can have changed are made anew; of both, all.
    VoxelLight update(const Inputs& inputs, StepTimer& timer) override;
    void invalidate() override { made_.reset(); }

    const VoxelPyramid& occupancy() const override { return voxels_.index(); }
    Resources resources() const override;

    const DirectionalVoxels& voxels() const { return voxels_; }
    // Null until a picture needed it.
    const Irradiance* received(GatherOf of) const;

  private:
    void makeVoxels(const Inputs& inputs, const std::optional<SceneState>& before, StepTimer& timer);
    std::optional<BlockMask> dirtySince(const std::optional<SceneState>& before, const Inputs& inputs) const;
    Irradiance& irradiance(GatherOf of, const GpuScene& scene);

    gl::ShaderLibrary shaders_;
    Settings settings_;
    LightFeatures sources_;
    double shadowTexel_;  // the longest side of a texel of the shadow map, in volume units
    DirectionalVoxels voxels_;
    DirectionalVoxelizer voxelizer_;
    DirectionalMipmapper mipmapper_;
    std::optional<IncrementalUpdate> incremental_;  // where something moves
    std::optional<Relighter> relighter_;            // since the light changed for the first time
    std::optional<Irradiance> light_, occlusion_;   // since a picture needed them
    bool allBounces_ = true;                        // in the received light
    std::optional<SceneState> made_;  // of what the voxels were made; nothing where they were not
};

}  // namespace vct
