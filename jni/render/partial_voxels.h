// Static and moving geometry apart, in voxels that are words: what moves is taken out and put in again, and
// of the rest only what it or its shadow can have changed. The voxels are the same as if all were made anew.
#pragma once

#include "render/changed_blocks.h"
#include "render/mipmapper.h"
#include "render/voxelizer.h"

namespace vct {

class PartialVoxels {
  public:
    PartialVoxels(const gl::ShaderLibrary& shaders, const GpuScene& scene, Voxelization voxelization);

    // Makes the base level's voxels in `changed` anew and leaves the others as they were; null: makes all of
    // them. What moves must have been in `changed` before, and must be in it now.
    void voxelize(const GpuScene& scene, const gl::Texture& shadowMap, const BlockMask* changed,
                  Voxelizer& voxelizer, Mipmapper& mipmapper, VoxelPyramid& voxels);
    // The coarser levels of that.
    void mipmap(VoxelPyramid& voxels);

    std::vector<const gl::Buffer*> buffers() const { return {&stillVoxels_, &stillCommands_, &mask_}; }

  private:
    // The static geometry's voxels of one level, sorted by block, or in any order where a voxel is larger.
    struct StillLevel {
        std::vector<std::uint32_t> entries;
        std::vector<std::uint32_t> firstOfBlock;  // and behind the last; empty where a voxel is larger
        std::uint32_t first = 0;                  // in stillVoxels_
        std::uint32_t firstEntry = 0;             // in the pyramid's list, where they come first too
    };
    // Entries of stillVoxels_.
    struct Range {
        std::uint32_t first = 0, end = 0;
    };
    void learn(const GpuScene& scene, const gl::Texture& shadowMap, Voxelizer& voxelizer,
               Mipmapper& mipmapper, VoxelPyramid& voxels);
    void choose(const BlockMask* changed);
    void takeOut(VoxelPyramid& voxels);
    void dispatchOverStill(std::size_t level, const Range& range, const VoxelPyramid& voxels) const;
    void dispatchFrom(std::uint32_t entry, std::size_t level, const VoxelPyramid& voxels) const;
    std::uint32_t firstMoving(std::size_t level) const;

    gl::Program clear_, mipmap_;
    MaterialPrograms still_;
    std::vector<StillLevel> levels_;      // empty until they are known
    std::vector<Range> cleared_, added_;  // of this frame: made anew, and added to the level above
    gl::Buffer stillVoxels_;              // of all levels; behind them, those that the frame makes anew
    gl::Buffer stillCommands_;            // those of the static geometry alone
    gl::Buffer mask_;
};

}  // namespace vct
