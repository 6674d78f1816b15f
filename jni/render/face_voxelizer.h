// The scene into the base level of the directional coverage voxels, lit by the shadow map: two passes over
// the triangles, then one over what they occupied.
#pragma once

#include "render/face_voxels.h"
#include "render/gpu_scene.h"

namespace vct {

// The square that the volume is projected to, along each of its axes. It has no targets: the rasterizer only
// makes fragments.
class FaceProjection {
  public:
    // `samples`: Settings::voxelSamples.
    FaceProjection(int grid, int samples);

    // Of draws to come.
    void use() const;

  private:
    glm::ivec4 viewport_;  // x, y, width, height
    gl::Framebuffer framebuffer_;
};

class FaceVoxelizer {
  public:
    // `samples`: as above.
    FaceVoxelizer(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid,
                  Voxelization voxelization, int samples);

    // Empties `voxels`, then writes its base level and the base level's list.
    void run(const GpuScene& scene, const gl::Texture& shadowMap, FaceVoxels& voxels);

  private:
    MaterialPrograms touch_, accumulate_;
    gl::Program resolve_;
    FaceProjection projection_;
};

}  // namespace vct
