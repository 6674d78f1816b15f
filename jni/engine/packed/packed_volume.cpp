#include "engine/packed/packed_volume.h"

namespace vct {

PackedVolume::PackedVolume(const gl::ShaderLibrary& shaders, const GpuScene& scene, const Settings& settings,
                           Voxelization voxelization)
    : pyramid_(shaders, settings.grid, settings.activeVoxelLimit),
      voxelizer_(shaders, scene, settings.grid, voxelization),
      mipmapper_(shaders) {}

VoxelLight PackedVolume::update(const Inputs& inputs, StepTimer& timer) {
    if (inputs.forceRebuild || cachedFor_ != inputs.now) {
        timer.time(Step::voxelize, [&] { voxelizer_.run(inputs.scene, inputs.light, pyramid_); });
        timer.time(Step::mipmap, [&] { mipmapper_.run(pyramid_); });
        cachedFor_ = inputs.now;
    }
    VoxelLight light;
    light.packed = &pyramid_.texture();
    return light;
}

Resources PackedVolume::resources() const {
    return pyramid_.resources();
}

}  // namespace vct
