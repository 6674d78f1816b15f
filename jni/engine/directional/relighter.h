// The directional coverage voxels in another light, where neither surfaces nor voxels changed: occupied
// voxels, coverage, albedo and lists stay, and of the triangles only the radiance is added up anew. The same
// faces as voxelized anew.
#pragma once

#include "engine/directional/directional_voxelizer.h"

namespace vct {

gl::ProgramDescription clearRadianceProgram();
gl::ProgramDescription relightProgram(unsigned features, Voxelization voxelization);
gl::ProgramDescription relightResolveProgram();

class Relighter {
  public:
    // As the DirectionalVoxelizer that made the voxels.
    Relighter(const gl::ShaderLibrary& shaders, const GpuScene& scene, int grid, Voxelization voxelization);

    // The base level of `voxels`. Afterwards it is ready to be fetched as a texture.
    void run(const GpuScene& scene, const DirectLight& light, const DirectionalVoxels& voxels);

  private:
    gl::Program clearRadiance_;
    MaterialPrograms accumulate_;
    gl::Program resolve_;
    FaceProjection projection_;
    gl::PlainSampler plainDepth_;  // the shadow map for shared/shadow.glsl
};

}  // namespace vct
