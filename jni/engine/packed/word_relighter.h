// Voxels that are words in another light, where neither surfaces nor voxels changed. A word keeps no albedo
// that could be lit, so the triangles are drawn again; but the lists of all levels stay. The same voxels as
// voxelized anew.
#pragma once

#include "engine/packed/packed_mipmapper.h"
#include "engine/packed/packed_voxelizer.h"

namespace vct {

class WordRelighter {
  public:
    WordRelighter(const gl::ShaderLibrary& shaders, const GpuScene& scene, Voxelization voxelization);

    // Empties `voxels` but for the lists, then writes its base level.
    void run(const GpuScene& scene, const gl::Texture& shadowMap, PackedVoxelizer& voxelizer, VoxelPyramid& voxels);
    // The coarser levels of that.
    void mipmap(VoxelPyramid& voxels) { mipmapper_.run(voxels); }

  private:
    MaterialPrograms programs_;
    PackedMipmapper mipmapper_;
};

}  // namespace vct
