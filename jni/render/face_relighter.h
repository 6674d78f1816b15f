// The directional coverage voxels in another light, where neither surfaces nor voxels changed: occupied
// voxels, coverage, albedo and lists stay, and of the triangles only the radiance is added up anew. The same
// faces as voxelized anew.
#pragma once

#include "render/face_voxelizer.h"

namespace vct {

class FaceRelighter {
  public:
    // As the FaceVoxelizer that made the voxels.
    FaceRelighter(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid,
                  Voxelization voxelization, int samples);

    // The base level of `voxels`. Afterwards it is ready to be fetched as a texture.
    void run(const GpuScene& scene, const gl::Texture& shadowMap, const FaceVoxels& voxels);

  private:
    gl::Program darken_;
    MaterialPrograms accumulate_;
    gl::Program resolve_;
    FaceProjection projection_;
    gl::PlainSampler plainDepth_;  // the shadow map for shared/shadow.glsl
};

}  // namespace vct
