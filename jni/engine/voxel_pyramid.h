// The occupied voxels: an R32UI 3D texture and the active-voxel lists. Both kinds of voxels use it.
#pragma once

#include <cstdint>
#include <optional>
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
        // The texture holds the packed voxels with all mip levels.
        packed,
        // The texture holds the index of the base level's faces (shaders/directional/index.glsl). With
        // cascades pages have it, and the texture is one texel.
        staticFaces,
        // The same for the static geometry; dynamic objects have separate lists.
        staticAndDynamicFaces,
    };
    // `baseCapacity`: entries of the base level's list; 0 means 16 grid^2, where a closed surface that fills
    // the volume needs about 6 grid^2, all times the number of cascades. A parent has at least one active
    // child, so no level needs more. `cascades`: cubes of grid^3 voxels, one behind the other along z
    // (shaders/directional/cascades.glsl).
    VoxelPyramid(const gl::ShaderLibrary& shaders, int grid, std::uint32_t baseCapacity,
                 Kind kind = Kind::packed, int cascades = 1);

    Resources resources() const;
    // Bytes of the texture and of the lists. Of cascades, at most.
    static std::size_t bytesFor(int grid, std::uint32_t baseCapacity, Kind kind = Kind::packed,
                                int cascades = 1);

    int grid() const { return grid_; }
    int levels() const { return levels_; }  // log2(grid) + 1, or 1 with directional voxels
    const gl::Texture& texture() const { return texture_; }
    const gl::Buffer& commands() const { return commands_; }
    const gl::Buffer& activeVoxels() const { return activeVoxels_; }

    // Clears the packed voxels that the previous frame listed, and resets the lists. Includes the barriers
    // before and after.
    void clear();
    // Clears the whole texture.
    void clearTexture() const { gl::clearTexture3d(texture_, depth_); }

    // The commands of empty lists.
    const shared::CommandLists& initialCommands() const { return initialCommands_; }
    // Replaces the commands of all lists.
    void setCommands(const shared::CommandLists& commands) const;
    void emptyFaceList(std::uint32_t list) const;
    void resetBlockedRays() const;
    // Sets the room for the sums of static faces (shaders/directional/face_sums.glsl).
    void setStaticSums(std::uint32_t faces, bool byId) const;

    // Binds one level for image access, and the lists and their commands for shaders.
    void bindLevel(int unit, int level, GLenum access) const;
    void bindLists() const;

    // Dispatches the current compute program over the active voxels of a level of packed voxels.
    void dispatchOverLevel(std::uint32_t level) const;
    // Dispatches it over the blocks with marked faces (shaders/directional/list_faces.comp).
    void dispatchOverMarkedBlocks() const;
    // Dispatches it over the face lists of the base level (0), or of one of VCT_BRICK_LEVEL and
    // VCT_LIST_VISITED.
    void dispatchOverFaces(int level) const;

    // Read the commands, and a level's list of active voxels. Wait for the GPU.
    shared::CommandLists readCommands() const;
    std::vector<std::uint32_t> readList(int level) const;
    // The number of active voxels of each level. Throws vct::Error with the needed capacity if a list
    // overflowed. Waits for the GPU.
    std::vector<std::uint32_t> readActiveCounts() const { return activeCounts(readCommands()); }
    std::vector<std::uint32_t> activeCounts(const shared::CommandLists& commands) const;

    std::uint32_t firstEntry(int level) const { return initialCommands_.lists[level].firstEntry; }

  private:
    // Dispatches the current compute program by the command at an offset of commands_, in bytes.
    void dispatch(std::size_t offset) const;

    int grid_, depth_, levels_;  // depth of the texture
    gl::Texture texture_;
    shared::CommandLists initialCommands_;
    gl::Buffer commands_, activeVoxels_;
    std::optional<gl::Buffer> dispatched_;  // copies of commands; only for drivers that need it (dispatch())
    gl::Program sparseClear_;
};

}  // namespace vct
