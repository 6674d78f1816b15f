#include "engine/packed/partial_voxels.h"

#include "gl/debug.h"
#include "engine/programs.h"

namespace vct {

using Of = ScenePart::Of;

PartialVoxels::PartialVoxels(const gl::ShaderLibrary& shaders, const GpuScene& scene,
                             Voxelization voxelization)
    : clear_(shaders, partialClearProgram()),
      mipmap_(shaders, partialMipmapperProgram()),
      static_(shaders, scene,
             [=](unsigned features) { return stillVoxelizerProgram(features, voxelization); }) {}

void PartialVoxels::voxelize(const GpuScene& scene, const gl::Texture& shadowMap, const BlockMask* changed,
                             PackedVoxelizer& voxelizer, PackedMipmapper& mipmapper, VoxelPyramid& voxels) {
    if (!staticVoxels_) {
        recordStatic(scene, shadowMap, voxelizer, mipmapper, voxels);
        changed = nullptr;
    }
    const gl::DebugGroup group("voxelize");
    staticVoxels_->choose(changed);
    if (changed != nullptr)
        removeDynamic(voxels);
    else
        voxels.clear();
    voxels.setCommands(staticCommands_);
    const BlockMask mask = changed != nullptr ? *changed : BlockMask::all();
    voxelizer.draw(scene, {Of::staticOnly, &mask}, static_, shadowMap, voxels);
    voxelizer.draw(scene, {Of::moving}, voxelizer.programs(), shadowMap, voxels);
}

// Which voxels the static geometry occupies, as no light and no pose changes that.
void PartialVoxels::recordStatic(const GpuScene& scene, const gl::Texture& shadowMap, PackedVoxelizer& voxelizer,
                          PackedMipmapper& mipmapper, VoxelPyramid& voxels) {
    const gl::DebugGroup group("static voxels");
    voxels.clear();
    voxelizer.draw(scene, {Of::staticOnly}, voxelizer.programs(), shadowMap, voxels);
    mipmapper.run(voxels);
    voxels.readActiveCounts();  // where the list has overflowed, that is said

    std::vector<BlockLists::List> levels;
    for (int i = 0; i < voxels.levels(); ++i)
        levels.push_back({voxels.readList(i), voxels.grid() >> i, shared::unpackEntry});
    staticCommands_ = voxels.copyCommands("static voxel commands");
    staticVoxels_.emplace("static voxels", std::move(levels));
}

void PartialVoxels::removeDynamic(VoxelPyramid& voxels) {
    const gl::DebugGroup group("take out");
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    voxels.bindLists();
    clear_.use();
    for (std::size_t level = 0; level < staticVoxels_->size(); ++level) {
        voxels.bindLevel(VCT_IMAGE_VOXELS, static_cast<int>(level), GL_WRITE_ONLY);
        // In the pyramid's list the static geometry's come first.
        staticVoxels_->dispatchOver(staticVoxels_->chosen(level), {staticVoxels_->count(level)}, level);
    }
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void PartialVoxels::mipmap(VoxelPyramid& voxels) {
    const gl::DebugGroup group("mipmap");
    voxels.bindLists();
    mipmap_.use();
    for (std::size_t level = 0; level + 1 < staticVoxels_->size(); ++level) {
        const int finer = static_cast<int>(level);
        voxels.bindLevel(VCT_IMAGE_VOXELS, finer, GL_READ_ONLY);
        voxels.bindLevel(VCT_IMAGE_VOXELS_NEXT, finer + 1, GL_READ_WRITE);
        // A parent as large as a block, or smaller, is made anew where its children are.
        staticVoxels_->dispatchOver(
            staticVoxels_->isInBlocks(level + 1) ? staticVoxels_->chosen(level) : staticVoxels_->all(level), {},
            level);
        // What moves finds every parent that is listed already.
        gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        staticVoxels_->dispatchOver({}, {staticVoxels_->count(level)}, level);
        gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    }
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT |
                      GL_COMMAND_BARRIER_BIT);
}

std::vector<const gl::Buffer*> PartialVoxels::buffers() const {
    if (!staticVoxels_) return {};
    std::vector<const gl::Buffer*> buffers = staticVoxels_->buffers();
    buffers.push_back(&staticCommands_);
    return buffers;
}

}  // namespace vct
