// The voxels that are not empty: an R32UI 3D texture, and the lists of them.
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
    enum class Kind {
        packed,                 // the texture holds the packed voxels, with all mip levels
        staticFaces,            // the texture holds the base level's index of faces:
                                // shaders/directional/face_lists.glsl
        staticAndDynamicFaces,  // likewise, of the static geometry, and dynamic objects have lists of their
                                // own
    };
    // `baseCapacity`: entries of the base level's list, or 0 for 16 grid^2 (a closed surface that fills the
    // volume has about 6 grid^2). A parent has at least one active child, so no other level needs more.
    VoxelPyramid(const gl::ShaderLibrary& shaders, int grid, std::uint32_t baseCapacity,
                 Kind kind = Kind::packed);

    Resources resources() const;
    // Bytes of the texture and the lists.
    static std::size_t bytesFor(int grid, std::uint32_t baseCapacity, Kind kind = Kind::packed);

    int grid() const { return grid_; }
    int levels() const { return levels_; }  // log2(grid) + 1
    const gl::Texture& texture() const { return texture_; }
    const gl::Buffer& commands() const { return commands_; }
    const gl::Buffer& activeVoxels() const { return activeVoxels_; }

    // Empties packed voxels through the last frame's list and resets the commands. No barrier is needed
    // before; afterwards the image and the buffers are ready for shaders.
    void clear();
    // Empties the texture, whatever is in it.
    void clearTexture() const { gl::clearTexture3d(texture_, grid_); }

    // The commands of empty lists; and the commands replaced.
    const shared::CommandLists& initialCommands() const { return initialCommands_; }
    void setCommands(const shared::CommandLists& commands) const;

    // Binds one level for image access, and the lists and their commands for shaders.
    void bindLevel(int unit, int level, GLenum access) const;
    void bindLists() const;

    // Dispatches the current compute program over the active voxels of a list.
    void dispatchOverLevel(std::uint32_t list) const;
    // Dispatches it over a level's faces that are not empty.
    void dispatchOverFaces(int level) const;

    // The commands, and what is active in a level's list. Wait for the GPU.
    shared::CommandLists readCommands() const;
    std::vector<std::uint32_t> readList(int level) const;
    // The active voxels of each level. Throws vct::Error where there were more than the list can hold, with
    // the number that is needed. Waits for the GPU.
    std::vector<std::uint32_t> readActiveCounts() const { return activeCounts(readCommands()); }
    std::vector<std::uint32_t> activeCounts(const shared::CommandLists& commands) const;

    std::uint32_t firstEntry(int level) const { return initialCommands_.lists[level].firstEntry; }

  private:
    int grid_, levels_;
    gl::Texture texture_;
    shared::CommandLists initialCommands_;
    gl::Buffer commands_, activeVoxels_;
    gl::Program sparseClear_;
};

}  // namespace vct
