#include "engine/directional/incremental_update.h"

#include <algorithm>

#include "engine/programs.h"
#include "gl/debug.h"

namespace vct {

using Of = ScenePart::Of;

IncrementalUpdate::IncrementalUpdate(const gl::ShaderLibrary& shaders, const GpuScene& scene,
                                     Voxelization voxelization)
    : clearBase_(shaders, dirtyClearBaseProgram()),
      resolve_(shaders, dirtyResolveProgram()),
      resolveStatic_(shaders, staticResolveProgram()),
      mipmap_(shaders, dirtyMipmapperProgram()),
      static_(shaders, scene,
              [=](unsigned features) { return staticVoxelizerProgram(features, voxelization); }) {}

void IncrementalUpdate::voxelize(const GpuScene& scene, const gl::Texture& shadowMap,
                                 const BlockMask* changed, DirectionalVoxelizer& voxelizer,
                                 DirectionalMipmapper& mipmapper, DirectionalVoxels& voxels) {
    keptFaces_ = staticFaces_;
    if (!staticEntries_) {
        keptFaces_ = 0;
        recordStatic(scene, shadowMap, voxelizer, mipmapper, voxels);
        changed = nullptr;
    }
    const gl::DebugGroup group("voxelize");
    replaceMoving(scene, changed, voxelizer, voxels);
    const BlockMask mask = changed != nullptr ? *changed : BlockMask::all();
    voxelizer.accumulate(scene, {Of::staticOnly, &mask}, static_, shadowMap, voxels);
    voxelizer.accumulate(scene, {Of::moving}, voxelizer.programs(), shadowMap, voxels);
    voxelizer.resolve(resolve_, voxels, [&] { dispatchOverPart(0, 2, voxels); });
}

// Which voxels and faces the static geometry fills, as no light and no pose changes that; and makes room for
// those of the present pose, and some more.
void IncrementalUpdate::recordStatic(const GpuScene& scene, const gl::Texture& shadowMap,
                                     DirectionalVoxelizer& voxelizer, DirectionalMipmapper& mipmapper,
                                     DirectionalVoxels& voxels) {
    const gl::DebugGroup group("static voxels");
    staticEntries_.reset();
    voxels.clear();
    voxelizer.touch(scene, {}, voxels);
    const std::uint32_t needed = withHeadRoom(voxels.index().readActiveCounts()[0]);
    voxels.clear();
    if (needed > voxels.places()) voxels.makeRoom(needed);
    voxelizer.touch(scene, {Of::staticOnly}, voxels);
    voxelizer.accumulate(scene, {Of::staticOnly}, voxelizer.programs(), shadowMap, voxels);
    voxelizer.resolve(resolveStatic_, voxels, [&] { voxels.index().dispatchOverLevel(0); });
    mipmapper.makeLevels(voxels);

    std::vector<BlockLists::List> lists{{voxels.index().readList(0), voxels.grid(), shared::unpackEntry}};
    for (int level = 1; level < voxels.levels(); ++level)
        lists.push_back({voxels.readFaceList(level), voxels.grid() >> level, shared::unpackFaceVoxel});
    staticCommands_ = voxels.index().copyCommands("static voxel commands");
    lastCommands_ = voxels.index().readCommands();
    staticFaces_ = lastCommands_[0].faceCount;
    staticEntries_.emplace("static voxels and faces", std::move(lists));
}

// In the base level's list; of the static voxels there and in `changed`, empties the sums.
void IncrementalUpdate::replaceMoving(const GpuScene& scene, const BlockMask* changed,
                                      DirectionalVoxelizer& voxelizer, DirectionalVoxels& voxels) {
    staticEntries_->choose(changed);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                      GL_TEXTURE_FETCH_BARRIER_BIT);
    voxels.bindLists();
    voxels.index().texture().bind(VCT_TEX_VOXELS);
    clearBase_.use();
    voxels.bindLevel(VCT_IMAGE_FACES, 0);
    voxels.index().bindLevel(VCT_IMAGE_VOXELS_NEXT, 0, GL_WRITE_ONLY);
    dispatchOverPart(0, 1, voxels);
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT |
                      GL_SHADER_STORAGE_BARRIER_BIT);
    voxels.setCommands(staticCommands_);
    voxelizer.touch(scene, {Of::moving}, voxels);
}

bool IncrementalUpdate::mipmap(DirectionalVoxels& voxels) {
    const gl::DebugGroup group("mipmap");
    voxels.bindLists();
    mipmap_.use();
    voxels.faces().bind(VCT_TEX_FACES);
    for (int level = 1; level < voxels.levels(); ++level) {
        voxels.bindLevel(VCT_IMAGE_FACES, level);
        if (level + 1 < voxels.levels())
            voxels.index().bindLevel(VCT_IMAGE_VOXELS_NEXT, level + 1, GL_READ_WRITE);
        dispatchOverPart(level, level + 2, voxels);
        gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                          GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    }
    gl::MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    lastCommands_ = voxels.index().readCommands();
    if (voxels.index().activeCounts(lastCommands_)[0] <= voxels.places()) return true;
    staticEntries_.reset();  // more room is made by emptying everything
    return false;
}

// Of the base level voxels, of coarser levels faces: those that were chosen, and what moves. Meanwhile the
// level `emptied`, where nothing has been put in again yet, is emptied of what moved.
void IncrementalUpdate::dispatchOverPart(int level, int emptied, const DirectionalVoxels& voxels) const {
    const auto list = static_cast<std::size_t>(level);
    const std::uint32_t still = staticEntries_->count(list);
    // As many as in the last frame, give or take a few.
    const std::uint32_t last = level == 0 ? lastCommands_[0].instanceCount : lastCommands_[list].faceCount;
    const BlockLists::Moving moving{still, last - still};
    std::uint32_t firstEmptied = 0, endEmptied = 0;
    if (emptied < voxels.levels()) {
        voxels.bindLevel(VCT_IMAGE_EMPTIED_FACES, emptied);
        voxels.index().bindLevel(VCT_IMAGE_EMPTIED_VOXELS, emptied, GL_READ_WRITE);
        const shared::LevelCommands& commands = lastCommands_[static_cast<std::size_t>(emptied)];
        firstEmptied = staticEntries_->count(static_cast<std::size_t>(emptied));
        endEmptied = std::min(commands.faceCount, commands.faceCapacity);
    }
    gl::Uniform1ui(VCT_UNIFORM_EMPTIED, firstEmptied);
    gl::Uniform1ui(VCT_UNIFORM_EMPTIED_END, endEmptied);
    staticEntries_->dispatchOver(staticEntries_->chosen(list), moving, list);
}

std::vector<const gl::Buffer*> IncrementalUpdate::buffers() const {
    if (!staticEntries_) return {};
    std::vector<const gl::Buffer*> buffers = staticEntries_->buffers();
    buffers.push_back(&staticCommands_);
    return buffers;
}

}  // namespace vct
