// The voxels: an R32UI 3D texture with all its mip levels, and the list of those that are not empty.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/resource.h"
#include "gl/objects.h"
#include "gl/program.h"
#include "shared/layout.h"

namespace vct {

gl::ProgramDescription packedClearProgram();

class VoxelPyramid {
  public:
    // `baseCapacity`: entries of the base level's list, or 0 for 16 grid^2 (a closed surface that fills the
    // volume has about 6 grid^2). A parent has at least one active child, so no other level needs more.
    VoxelPyramid(const gl::ShaderLibrary& shaders, int grid, std::uint32_t baseCapacity);

    Resources resources() const;
    // Memory of the texture and the list.
    static std::size_t bytesFor(int grid, std::uint32_t baseCapacity);

    int grid() const { return grid_; }
    int levels() const { return texture_.levels(); }  // log2(grid) + 1
    const gl::Texture& texture() const { return texture_; }
    const gl::Buffer& activeVoxels() const { return activeVoxels_; }

    // Empties the pyramid through the last frame's list and resets the commands. No barrier is needed before;
    // afterwards the image and the buffers are ready for shaders.
    void clear();
    // The halves of clear(). The first one empties the texture, without a barrier behind it; the second one
    // resets the lists while the texture is being emptied.
    void zero();
    void emptyLists();

    // Says which entries of the lists are active, as readCommands() has it.
    void setCommands(const std::vector<shared::LevelCommands>& commands);

    // Binds one level for image access, and the list and its commands for shaders.
    void bindLevel(int unit, int level, GLenum access) const;
    void bindLists() const;

    // Dispatches the current compute program over the active voxels of a level.
    void dispatchOverLevel(int level) const;
    // Dispatches it over the faces of a level that are not empty.
    void dispatchOverFaces(int level) const;

    // Says where the levels' lists of faces lie in the buffer that holds them: from word `first` on, six for
    // each of the base level's `voxels`; a coarser level has no more of them. Returns the word behind the
    // last.
    std::size_t placeFaceLists(std::size_t first, std::uint32_t voxels);

    // The commands of each level, and what is active in a level's list. Wait for the GPU.
    std::vector<shared::LevelCommands> readCommands() const;
    std::vector<std::uint32_t> readList(int level) const;
    // The active voxels of each level, by its commands. Throws vct::Error where there were more than the list
    // can hold, with the number that is needed.
    std::vector<std::uint32_t> activeCounts(const std::vector<shared::LevelCommands>& commands) const;
    std::vector<std::uint32_t> readActiveCounts() const { return activeCounts(readCommands()); }

    std::uint32_t firstEntry(int level) const { return initialCommands_[level].firstEntry; }

  private:
    int grid_;
    gl::Texture texture_;
    std::vector<shared::LevelCommands> initialCommands_;
    gl::Buffer commands_, activeVoxels_;
    gl::Program sparseClear_;
};

}  // namespace vct
