// The thesis's volume: packed voxels, through which each pixel traces cones.
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

    // Rebuilds all voxels if a light or the pose has changed.
    VoxelLight update(const Inputs& inputs, StepTimer& timer) override;
    void invalidate() override { cachedFor_.reset(); }

    const VoxelPyramid& occupancy() const override { return pyramid_; }
    Resources resources() const override;

  private:
    VoxelPyramid pyramid_;
    PackedVoxelizer voxelizer_;
    PackedMipmapper mipmapper_;
    std::optional<SceneState> cachedFor_;  // the state that the voxels were made for, if they are valid
};

}  // namespace vct
