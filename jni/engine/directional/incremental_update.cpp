#include "engine/directional/incremental_update.h"

#include <algorithm>

#include "engine/programs.h"
#include "gl/debug.h"

namespace vct {

gl::ProgramDescription staticVoxelizerProgram(unsigned features, Voxelization voxelization) {
    return voxelizing("directional/voxelizer",
                      featureDefines(features, voxelFeatures, {"VCT_RELIGHT false", "VCT_DIRTY_BLOCKS"}),
                      voxelization);
}

gl::ProgramDescription staticResolveProgram() {
    return {"directional/resolve of what is static", {"directional/resolve.comp"}, {"VCT_STATIC true"}};
}

gl::ProgramDescription dirtyResolveProgram() {
    return {"directional/resolve_dirty", {"directional/resolve_dirty.comp"}, {}};
}

gl::ProgramDescription dirtyMipmapperProgram() {
    return {"directional/mipmapper_dirty", {"directional/mipmapper_dirty.comp"}, {}};
}

gl::ProgramDescription dirtyClearBaseProgram() {
    return {"directional/clear_base_dirty", {"directional/clear_base_dirty.comp"}, {}};
}

gl::ProgramDescription clearDynamicProgram() {
    return {"directional/clear_dynamic", {"directional/clear_dynamic.comp"}, {}};
}

using Of = ScenePart::Of;

IncrementalUpdate::IncrementalUpdate(const gl::ShaderLibrary& shaders, const GpuScene& scene,
                                     Voxelization voxelization)
    : clearBase_(shaders, dirtyClearBaseProgram()),
      clearDynamic_(shaders, clearDynamicProgram()),
      resolve_(shaders, dirtyResolveProgram()),
      resolveStatic_(shaders, staticResolveProgram()),
      mipmap_(shaders, dirtyMipmapperProgram()),
      static_(shaders, scene,
              [=](unsigned features) { return staticVoxelizerProgram(features, voxelization); }) {}

void IncrementalUpdate::voxelize(const GpuScene& scene, const DirectLight& light, const BlockMask* changed,
                                 DirectionalVoxelizer& voxelizer, DirectionalMipmapper& mipmapper,
                                 DirectionalVoxels& voxels) {
    keptFaces_ = staticFaces_;
    if (!staticEntries_) {
        keptFaces_ = 0;
        recordStatic(scene, light, voxelizer, mipmapper, voxels);
        changed = nullptr;
    }
    const gl::DebugGroup group("voxelize");
    replaceDynamic(scene, changed, voxelizer, voxels);
    const BlockMask mask = changed != nullptr ? *changed : BlockMask::all();
    voxelizer.accumulate(scene, {Of::staticOnly, &mask}, static_, light, voxels);
    voxelizer.accumulate(scene, {Of::moving}, voxelizer.programs(), light, voxels);
    voxelizer.resolve(resolve_, voxels, [&] { dispatchOverPart(0); });
}

// Which voxels and faces the static geometry fills, as no light and no pose changes that; and makes room for
// those of the present pose, and some more.
void IncrementalUpdate::recordStatic(const GpuScene& scene, const DirectLight& light,
                                     DirectionalVoxelizer& voxelizer, DirectionalMipmapper& mipmapper,
                                     DirectionalVoxels& voxels) {
    const gl::DebugGroup group("static voxels");
    staticEntries_.reset();
    voxels.clear();
    voxelizer.markOccupied(scene, {}, voxels);
    const std::uint32_t needed = withHeadRoom(voxels.index().readActiveCounts()[0]);
    voxels.clear();
    if (needed > voxels.places()) voxels.makeRoom(needed);
    voxelizer.markOccupied(scene, {Of::staticOnly}, voxels);
    voxelizer.accumulate(scene, {Of::staticOnly}, voxelizer.programs(), light, voxels);
    voxelizer.resolve(resolveStatic_, voxels, [&] { voxels.index().dispatchOverLevel(0); });
    mipmapper.makeLevels(voxels);

    std::vector<BlockLists::List> lists{{voxels.index().readList(0), voxels.grid(), shared::unpackEntry}};
    for (int level = 1; level < voxels.levels(); ++level)
        lists.push_back({voxels.readFaceList(level), voxels.grid() >> level, shared::unpackFaceVoxel});
    staticCommands_ = lastCommands_ = voxels.index().readCommands();
    staticFaces_ = lastCommands_[0].faceCount;
    staticEntries_.emplace("static voxels and faces", std::move(lists));
}

// In the base level's list; of the static voxels there and in `changed`, empties the sums.
void IncrementalUpdate::replaceDynamic(const GpuScene& scene, const BlockMask* changed,
                                       DirectionalVoxelizer& voxelizer, DirectionalVoxels& voxels) {
    staticEntries_->choose(changed);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                      GL_TEXTURE_FETCH_BARRIER_BIT);
    voxels.bindLists();
    clearDynamic(voxels);
    voxels.index().texture().bind(VCT_TEX_VOXELS);
    clearBase_.use();
    voxels.bindLevel(VCT_IMAGE_FACES, 0);
    voxels.index().bindLevel(VCT_IMAGE_VOXELS, 0, GL_WRITE_ONLY);
    dispatchOverPart(0);
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT |
                      GL_SHADER_STORAGE_BARRIER_BIT);
    voxels.setCommands(staticCommands_);
    voxelizer.markOccupied(scene, {Of::moving}, voxels);
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
        dispatchOverPart(level);
        gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                          GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    }
    gl::MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    lastCommands_ = voxels.index().readCommands();
    const bool hadRoom = lastCommands_[0].voxelCount <= voxels.places();
    if (!hadRoom) staticEntries_.reset();        // more room is made by emptying everything
    voxels.index().activeCounts(lastCommands_);  // throws where the list itself is too short
    return hadRoom;
}

// Of the levels above the base level.
void IncrementalUpdate::clearDynamic(const DirectionalVoxels& voxels) const {
    clearDynamic_.use();
    for (int level = 1; level < voxels.levels(); ++level) {
        const auto list = static_cast<std::size_t>(level);
        const std::uint32_t first = staticEntries_->count(list);
        const std::uint32_t end = std::min(lastCommands_[list].faceCount, lastCommands_[list].faceCapacity);
        if (first >= end) continue;
        voxels.bindLevel(VCT_IMAGE_FACES, level);
        voxels.index().bindLevel(VCT_IMAGE_VOXELS, level, GL_READ_WRITE);
        gl::Uniform1ui(VCT_UNIFORM_LEVEL, static_cast<GLuint>(level));
        gl::Uniform1ui(VCT_UNIFORM_FIRST, first);
        gl::Uniform1ui(VCT_UNIFORM_END, end);
        gl::DispatchCompute((end - first - 1) / VCT_LIST_GROUP + 1, 1, 1);
    }
}

// Runs the current program over the static entries that were chosen, and what moves: over voxels of the base
// level, over faces of coarser ones.
void IncrementalUpdate::dispatchOverPart(int level) const {
    const auto list = static_cast<std::size_t>(level);
    const std::uint32_t staticCount = staticEntries_->count(list);
    // What moves is as much as in the last frame, give or take a few.
    const std::uint32_t last = level == 0 ? lastCommands_[0].voxelCount : lastCommands_[list].faceCount;
    staticEntries_->dispatchOver(staticEntries_->chosen(list), {staticCount, last - staticCount}, list);
}

std::vector<const gl::Buffer*> IncrementalUpdate::buffers() const {
    if (!staticEntries_) return {};
    return staticEntries_->buffers();
}

}  // namespace vct
