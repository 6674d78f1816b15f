// Static and moving geometry apart, in voxels that are words: what moves is taken out and put in again, and
// of the rest only what it or its shadow can have changed. The voxels are the same as if all were made anew.
#pragma once

#include <optional>

#include "engine/directional/block_lists.h"
#include "engine/packed/packed_mipmapper.h"
#include "engine/packed/packed_voxelizer.h"

namespace vct {

class PartialVoxels {
  public:
    PartialVoxels(const gl::ShaderLibrary& shaders, const GpuScene& scene, Voxelization voxelization);

    // Makes the base level's voxels in `changed` anew and leaves the others as they were; null: makes all of
    // them. What moves must have been in `changed` before, and must be in it now.
    void voxelize(const GpuScene& scene, const gl::Texture& shadowMap, const BlockMask* changed,
                  PackedVoxelizer& voxelizer, PackedMipmapper& mipmapper, VoxelPyramid& voxels);
    // The coarser levels of that.
    void mipmap(VoxelPyramid& voxels);

    std::vector<const gl::Buffer*> buffers() const;

  private:
    void recordStatic(const GpuScene& scene, const gl::Texture& shadowMap, PackedVoxelizer& voxelizer,
               PackedMipmapper& mipmapper, VoxelPyramid& voxels);
    void removeDynamic(VoxelPyramid& voxels);
    gl::Program clear_, mipmap_;
    MaterialPrograms static_;
    std::optional<BlockLists> staticVoxels_;  // of each level; nothing until they are known
    gl::Buffer staticCommands_;               // those of the static geometry alone
};

}  // namespace vct
