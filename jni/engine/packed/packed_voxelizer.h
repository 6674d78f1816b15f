// The scene into the base level of the voxels, lit by the shadow map (thesis 4.4).
#pragma once

#include "engine/gpu_scene.h"
#include "engine/voxel_pyramid.h"

namespace vct {

class PackedVoxelizer {
  public:
    // `samples`: Settings::voxelSamples.
    PackedVoxelizer(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid, Voxelization voxelization,
              int samples);

    // Empties `voxels`, then writes its base level and the base level's list.
    void run(const GpuScene& scene, const gl::Texture& shadowMap, VoxelPyramid& voxels);
    // Adds a part of the scene to the base level and its list. The programs: those for all of it, or others
    // of the same features.
    void draw(const GpuScene& scene, const ScenePart& part, const MaterialPrograms& programs,
              const gl::Texture& shadowMap, VoxelPyramid& voxels);
    const MaterialPrograms& programs() const { return programs_; }

  private:
    MaterialPrograms programs_;
    int pixels_;                   // along each side
    gl::Framebuffer framebuffer_;  // no attachments: the rasterizer only makes fragments
};

}  // namespace vct
