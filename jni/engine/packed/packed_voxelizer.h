// Voxelizes the scene into the base level of the packed voxels, lit through the shadow map (thesis 4.4).
#pragma once

#include "engine/gpu_scene.h"
#include "engine/passes/punctual_lights.h"
#include "engine/voxel_pyramid.h"

namespace vct {

gl::ProgramDescription packedVoxelizerProgram(unsigned features, Voxelization voxelization);

class PackedVoxelizer {
  public:
    PackedVoxelizer(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid,
                    Voxelization voxelization);

    // Clears `voxels`, then writes the base level and its active-voxel list.
    void run(const GpuScene& scene, const DirectLight& light, VoxelPyramid& voxels);

  private:
    MaterialPrograms programs_;
    gl::Framebuffer framebuffer_;  // without attachments: fragments write to the voxel image
};

}  // namespace vct
