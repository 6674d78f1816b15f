// Directional voxels of a scene where something moves. What moves is removed from them and put in again; of
// the static geometry only the blocks that what moves, or its shadow, can have changed are made anew. The
// voxels are the same as if all were made anew. The static ones come first in the lists, and keep their
// places there, which are those of their sums.
#pragma once

#include <optional>

#include "engine/directional/block_lists.h"
#include "engine/directional/directional_mipmapper.h"
#include "engine/directional/directional_voxelizer.h"

namespace vct {

// Of the static geometry alone.
gl::ProgramDescription staticVoxelizerProgram(unsigned features, Voxelization voxelization);
gl::ProgramDescription staticResolveProgram();
// Of what is in dirty blocks, and of what moves.
gl::ProgramDescription dirtyResolveProgram();
gl::ProgramDescription dirtyMipmapperProgram();
gl::ProgramDescription dirtyClearBaseProgram();
gl::ProgramDescription clearDynamicProgram();

class IncrementalUpdate {
  public:
    IncrementalUpdate(const gl::ShaderLibrary& shaders, const GpuScene& scene, Voxelization voxelization);

    // Makes the base level's faces in `changed` anew and leaves the others as they were; null: makes all of
    // them. What moves must have been in `changed` before, and must be in it now.
    void voxelize(const GpuScene& scene, const DirectLight& light, const BlockMask* changed,
                  DirectionalVoxelizer& voxelizer, DirectionalMipmapper& mipmapper,
                  DirectionalVoxels& voxels);
    // The coarser levels of that. False where there were more voxels than there is room for: to be made again
    // from the start.
    bool mipmap(DirectionalVoxels& voxels);

    // Of the base level's list of faces: those of the static geometry, which keep their places; 0 where they
    // were found out in the last voxelize().
    std::uint32_t keptFaces() const { return keptFaces_; }

    std::vector<const gl::Buffer*> buffers() const;

  private:
    void recordStatic(const GpuScene& scene, const DirectLight& light, DirectionalVoxelizer& voxelizer,
                      DirectionalMipmapper& mipmapper, DirectionalVoxels& voxels);
    void replaceDynamic(const GpuScene& scene, const BlockMask* changed, DirectionalVoxelizer& voxelizer,
                        DirectionalVoxels& voxels);
    void clearDynamic(const DirectionalVoxels& voxels) const;
    void dispatchOverPart(int level) const;

    gl::Program clearBase_, clearDynamic_, resolve_, resolveStatic_, mipmap_;
    MaterialPrograms static_;
    // The base level's voxels, and the faces of the coarser levels; nothing until they are known.
    std::optional<BlockLists> staticEntries_;
    std::uint32_t staticFaces_ = 0, keptFaces_ = 0;
    // The commands of the static geometry alone, and those of the last frame.
    std::vector<shared::LevelCommands> staticCommands_, lastCommands_;
};

}  // namespace vct
