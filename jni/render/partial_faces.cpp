#include "render/partial_faces.h"

#include "gl/debug.h"
#include "render/programs.h"

namespace vct {

using Of = ScenePart::Of;

PartialFaces::PartialFaces(const gl::ShaderLibrary& shaders, const GpuScene& scene, Voxelization voxelization)
    : clearBase_(shaders, partialFaceClearBaseProgram()),
      clear_(shaders, partialFaceClearProgram()),
      resolve_(shaders, partialFaceResolveProgram()),
      resolveStill_(shaders, stillFaceResolveProgram()),
      mipmap_(shaders, partialFaceMipmapperProgram()),
      still_(shaders, scene,
             [=](unsigned features) { return stillFaceVoxelizerProgram(features, voxelization); }) {}

void PartialFaces::voxelize(const GpuScene& scene, const gl::Texture& shadowMap, const BlockMask* changed,
                            FaceVoxelizer& voxelizer, FaceMipmapper& mipmapper, FaceVoxels& voxels) {
    if (!stillEntries_) {
        learn(scene, shadowMap, voxelizer, mipmapper, voxels);
        changed = nullptr;
    }
    const gl::DebugGroup group("voxelize");
    replaceMoving(scene, changed, voxelizer, voxels);
    if (voxels.slots().readActiveCounts()[0] > voxels.places()) {
        // More room is made by emptying everything.
        learn(scene, shadowMap, voxelizer, mipmapper, voxels);
        changed = nullptr;
        replaceMoving(scene, changed, voxelizer, voxels);
    }
    const BlockMask mask = changed != nullptr ? *changed : BlockMask::all();
    voxelizer.accumulate(scene, {Of::still, &mask}, still_, shadowMap, voxels);
    voxelizer.accumulate(scene, {Of::moving}, voxelizer.programs(), shadowMap, voxels);
    voxelizer.resolve(resolve_, voxels, [&] { dispatchOverPart(0, voxels); });
    everythingAnew_ = changed == nullptr;
}

// Which voxels and faces the static geometry fills, as no light and no pose changes that; and makes room for
// those of the present pose, and some more.
void PartialFaces::learn(const GpuScene& scene, const gl::Texture& shadowMap, FaceVoxelizer& voxelizer,
                         FaceMipmapper& mipmapper, FaceVoxels& voxels) {
    const gl::DebugGroup group("static voxels");
    stillEntries_.reset();
    voxels.clear();
    voxelizer.touch(scene, {}, voxels);
    const std::uint32_t needed = withHeadRoom(voxels.slots().readActiveCounts()[0]);
    voxels.clear();
    if (needed > voxels.places()) voxels.makeRoom(needed);
    voxelizer.touch(scene, {Of::still}, voxels);
    voxelizer.accumulate(scene, {Of::still}, voxelizer.programs(), shadowMap, voxels);
    voxelizer.resolve(resolveStill_, voxels, [&] { voxels.slots().dispatchOverLevel(0); });
    mipmapper.makeLevels(voxels, 1);

    std::vector<BlockLists::List> lists{{voxels.slots().readList(0), voxels.grid(), shared::unpackEntry}};
    stillFaces_.clear();
    for (int level = 0; level < voxels.levels(); ++level) {
        std::vector<std::uint32_t> faces = voxels.readFaceList(level);
        stillFaces_.push_back(static_cast<std::uint32_t>(faces.size()));
        const int side = voxels.grid() >> level;
        if (level > 0 && side >= BlockMask::side)
            lists.push_back({std::move(faces), side, shared::unpackFaceVoxel});
    }
    stillCommands_ = voxels.slots().copyCommands("static voxel commands");
    stillEntries_.emplace("static voxels and faces", std::move(lists));
}

// In the base level's list; of the static voxels there and in `changed`, empties the sums.
void PartialFaces::replaceMoving(const GpuScene& scene, const BlockMask* changed, FaceVoxelizer& voxelizer,
                                 FaceVoxels& voxels) {
    stillEntries_->choose(changed);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                      GL_TEXTURE_FETCH_BARRIER_BIT);
    voxels.slots().texture().bind(VCT_TEX_VOXELS);
    clearBase_.use();
    voxels.bindLevel(VCT_IMAGE_FACES, 0);
    voxels.slots().bindLevel(VCT_IMAGE_VOXELS, 0, GL_WRITE_ONLY);
    dispatchOverPart(0, voxels);
    clear_.use();
    for (int level = 1; level < voxels.levels(); ++level) {
        voxels.bindLevel(VCT_IMAGE_FACES, level);
        voxels.slots().bindLevel(VCT_IMAGE_VOXELS, level, GL_READ_WRITE);
        dispatchFrom(stillFaces_[static_cast<std::size_t>(level)], static_cast<std::size_t>(level));
    }
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT |
                      GL_SHADER_STORAGE_BARRIER_BIT);
    voxels.setCommands(stillCommands_);
    voxelizer.touch(scene, {Of::moving}, voxels);
}

void PartialFaces::mipmap(FaceVoxels& voxels, FaceMipmapper& mipmapper, const FaceBounces* bounces) {
    const auto coarse =
        static_cast<int>(stillEntries_->size());  // the first level of voxels larger than blocks
    {
        const gl::DebugGroup group("mipmap");
        mipmap_.use();
        voxels.faces().bind(VCT_TEX_FACES);
        for (int level = 1; level < coarse; ++level) {
            voxels.bindLevel(VCT_IMAGE_FACES, level);
            voxels.slots().bindLevel(VCT_IMAGE_VOXELS_NEXT, level + 1, GL_READ_WRITE);
            dispatchOverPart(static_cast<std::size_t>(level), voxels);
            gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                              GL_COMMAND_BARRIER_BIT);
        }
        if (bounces != nullptr && !everythingAnew_) bounces->restoreDirect(voxels);
    }
    mipmapper.makeLevels(voxels, coarse);
}

// Of the base level voxels, of coarser levels faces: those that were chosen, and what moves.
void PartialFaces::dispatchOverPart(std::size_t level, const FaceVoxels& voxels) const {
    voxels.bindLists();
    stillEntries_->dispatchOver(stillEntries_->chosen(level), level);
    voxels.bindLists();
    dispatchFrom(level == 0 ? stillEntries_->count(0) : stillFaces_[level], level);
}

std::vector<const gl::Buffer*> PartialFaces::buffers() const {
    if (!stillEntries_) return {};
    std::vector<const gl::Buffer*> buffers = stillEntries_->buffers();
    buffers.push_back(&stillCommands_);
    return buffers;
}

}  // namespace vct
