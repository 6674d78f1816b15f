// The thesis's volume: packed voxels, through which every pixel sends its own cones.
#pragma once

#include <optional>

#include "engine/packed/packed_mipmapper.h"
#include "engine/packed/packed_voxelizer.h"
#include "engine/voxel_volume.h"

namespace vct {

class PackedVolume final : public VoxelVolume {
  public:
    PackedVolume(const gl::ShaderLibrary& shaders, const GpuScene& scene, const Settings& settings,
                 Voxelization voxelization);

    // Another pose or light rebuilds all voxels, as in the thesis.
    VoxelLight update(const Inputs& inputs, StepTimer& timer) override;
    void invalidate() override { cachedFor_.reset(); }

    const VoxelPyramid& occupancy() const override { return pyramid_; }
    Resources resources() const override;

  private:
    VoxelPyramid pyramid_;
    PackedVoxelizer voxelizer_;
    PackedMipmapper mipmapper_;
    std::optional<SceneState> cachedFor_;  // that the voxels were made for; empty where they are out of date
};

}  // namespace vct
