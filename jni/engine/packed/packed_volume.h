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

    // Voxels of another pose or light are made anew as a whole, as in the thesis.
    VoxelLight update(const Inputs& inputs, StepTimer& timer) override;
    void forget() override { made_.reset(); }

    const VoxelPyramid& occupancy() const override { return pyramid_; }
    Resources resources() const override;

  private:
    VoxelPyramid pyramid_;
    PackedVoxelizer voxelizer_;
    PackedMipmapper mipmapper_;
    std::optional<SceneState> made_;  // of what the voxels were made; nothing where they were not
};

}  // namespace vct
