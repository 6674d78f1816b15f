// The scene into the base level of the directional coverage voxels, lit by the shadow map: two passes over
// the triangles, then one over what they occupied.
#pragma once

#include "render/face_voxels.h"
#include "render/gpu_scene.h"

namespace vct {

class FaceVoxelizer {
  public:
    // `samples`: Settings::voxelSamples.
    FaceVoxelizer(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid,
                  Voxelization voxelization, int samples);

    // Empties `voxels`, then writes its base level and the base level's list.
    void run(const GpuScene& scene, const gl::Texture& shadowMap, FaceVoxels& voxels);

  private:
    MaterialPrograms touch_, accumulate_;
    gl::Program resolve_;
    glm::ivec4 viewport_;          // x, y, width, height
    gl::Framebuffer framebuffer_;  // no attachments: the rasterizer only makes fragments
};

}  // namespace vct
