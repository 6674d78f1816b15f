// The scene into the base level of the voxels, lit by the shadow map (thesis 4.4).
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

    // Empties `voxels`, then writes its base level and the base level's list.
    void run(const GpuScene& scene, const DirectLight& light, VoxelPyramid& voxels);

  private:
    MaterialPrograms programs_;
    gl::Framebuffer framebuffer_;  // no attachments: the rasterizer only makes fragments
};

}  // namespace vct
