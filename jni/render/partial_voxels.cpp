#include "render/partial_voxels.h"

#include <algorithm>

#include "gl/debug.h"
#include "render/programs.h"

namespace vct {

namespace {

using Of = ScenePart::Of;

constexpr std::size_t blockCount = BlockMask::side * BlockMask::side * BlockMask::side;

std::size_t blockOf(std::uint32_t entry, int levelSide) {
    const glm::uvec3 block = shared::unpackEntry(entry) * static_cast<unsigned>(BlockMask::side) /
                             static_cast<unsigned>(levelSide);
    return block.x + BlockMask::side * (block.y + std::size_t{BlockMask::side} * block.z);
}

// Sorts the entries by block; returns where each block's begin, and behind the last.
std::vector<std::uint32_t> sortByBlock(std::vector<std::uint32_t>& entries, int levelSide) {
    std::vector<std::uint32_t> first(blockCount + 1);
    for (const std::uint32_t entry : entries)
        ++first[blockOf(entry, levelSide) + 1];
    for (std::size_t block = 0; block < blockCount; ++block)
        first[block + 1] += first[block];
    std::vector<std::uint32_t> next = first, sorted(entries.size());
    for (const std::uint32_t entry : entries)
        sorted[next[blockOf(entry, levelSide)]++] = entry;
    entries = std::move(sorted);
    return first;
}

// Enough to keep a GPU busy; each invocation takes as many entries as there are for it.
constexpr GLuint mostGroups = 1024;

}  // namespace

PartialVoxels::PartialVoxels(const gl::ShaderLibrary& shaders, const GpuScene& scene,
                             Voxelization voxelization)
    : clear_(shaders, partialClearProgram()),
      mipmap_(shaders, partialMipmapperProgram()),
      still_(shaders, scene,
             [=](unsigned features) { return stillVoxelizerProgram(features, voxelization); }),
      mask_("changed blocks", GL_UNIFORM_BUFFER, blockCount / 8, nullptr, GL_DYNAMIC_DRAW) {}

void PartialVoxels::voxelize(const GpuScene& scene, const gl::Texture& shadowMap, const BlockMask* changed,
                             Voxelizer& voxelizer, Mipmapper& mipmapper, VoxelPyramid& voxels) {
    if (levels_.empty()) {
        learn(scene, shadowMap, voxelizer, mipmapper, voxels);
        changed = nullptr;
    }
    const gl::DebugGroup group("voxelize");
    choose(changed);
    const BlockMask mask = changed != nullptr ? *changed : BlockMask::all();
    mask_.bind(GL_UNIFORM_BUFFER);
    gl::BufferSubData(GL_UNIFORM_BUFFER, 0, static_cast<GLsizeiptr>(mask_.bytes()), mask.rows().data());
    mask_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_CHANGED_BLOCKS);
    if (changed != nullptr)
        takeOut(voxels);
    else
        voxels.clear();
    voxels.setCommands(stillCommands_);
    voxelizer.draw(scene, {Of::still, &mask}, still_, shadowMap, voxels);
    voxelizer.draw(scene, {Of::moving}, voxelizer.programs(), shadowMap, voxels);
}

// Which voxels the static geometry occupies, as no light and no pose changes that.
void PartialVoxels::learn(const GpuScene& scene, const gl::Texture& shadowMap, Voxelizer& voxelizer,
                          Mipmapper& mipmapper, VoxelPyramid& voxels) {
    const gl::DebugGroup group("static voxels");
    voxels.clear();
    voxelizer.draw(scene, {Of::still}, voxelizer.programs(), shadowMap, voxels);
    mipmapper.run(voxels);
    const std::vector<std::uint32_t> counts = voxels.readActiveCounts();
    std::vector<std::uint32_t> list(voxels.firstEntry(voxels.levels() - 1) + counts.back());
    voxels.activeVoxels().read(list.data(), list.size() * sizeof list[0]);

    std::vector<StillLevel> levels;
    std::vector<std::uint32_t> all;
    std::size_t inBlocks = 0;  // which are copied behind the others, where they are made anew
    for (int i = 0; i < voxels.levels(); ++i) {
        StillLevel& level = levels.emplace_back();
        level.firstEntry = voxels.firstEntry(i);
        const auto begin = list.begin() + level.firstEntry;
        level.entries.assign(begin, begin + counts[static_cast<std::size_t>(i)]);
        if (voxels.grid() >> i >= BlockMask::side) {
            level.firstOfBlock = sortByBlock(level.entries, voxels.grid() >> i);
            inBlocks += level.entries.size();
        }
        level.first = static_cast<std::uint32_t>(all.size());
        all.insert(all.end(), level.entries.begin(), level.entries.end());
    }
    all.resize(std::max<std::size_t>(all.size() + inBlocks, 1));
    stillVoxels_ = gl::Buffer("static voxels", GL_SHADER_STORAGE_BUFFER, all.size() * sizeof all[0],
                              all.data(), GL_DYNAMIC_DRAW);
    stillCommands_ = voxels.copyCommands("static voxel commands");
    levels_ = std::move(levels);
}

void PartialVoxels::choose(const BlockMask* changed) {
    cleared_.assign(levels_.size(), {});
    added_.assign(levels_.size(), {});
    const StillLevel& last = levels_.back();
    const std::uint32_t firstCopied = last.first + static_cast<std::uint32_t>(last.entries.size());
    std::vector<std::uint32_t> copied;
    const std::vector<std::uint32_t> blocks =
        changed != nullptr ? changed->blocks() : std::vector<std::uint32_t>();
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const StillLevel& level = levels_[i];
        const Range whole{level.first, level.first + static_cast<std::uint32_t>(level.entries.size())};
        cleared_[i] = added_[i] = whole;
        if (changed == nullptr || level.firstOfBlock.empty()) continue;
        cleared_[i].first = firstCopied + static_cast<std::uint32_t>(copied.size());
        for (const std::uint32_t block : blocks)
            copied.insert(copied.end(), level.entries.begin() + level.firstOfBlock[block],
                          level.entries.begin() + level.firstOfBlock[block + 1]);
        cleared_[i].end = firstCopied + static_cast<std::uint32_t>(copied.size());
        // A parent as large as a block, or smaller, is made anew where its children are.
        if (!levels_[i + 1].firstOfBlock.empty()) added_[i] = cleared_[i];
    }
    if (copied.empty()) return;
    stillVoxels_.bind(GL_COPY_WRITE_BUFFER);
    gl::BufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(firstCopied * sizeof copied[0]),
                      static_cast<GLsizeiptr>(copied.size() * sizeof copied[0]), copied.data());
}

void PartialVoxels::takeOut(VoxelPyramid& voxels) {
    const gl::DebugGroup group("take out");
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    clear_.use();
    for (std::size_t level = 0; level < levels_.size(); ++level) {
        voxels.bindLevel(VCT_IMAGE_VOXELS, static_cast<int>(level), GL_WRITE_ONLY);
        if (levels_[level].firstOfBlock.empty()) {
            dispatchFrom(levels_[level].firstEntry, level, voxels);
            continue;
        }
        dispatchOverStill(level, cleared_[level], voxels);
        dispatchFrom(firstMoving(level), level, voxels);
    }
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void PartialVoxels::mipmap(VoxelPyramid& voxels) {
    const gl::DebugGroup group("mipmap");
    mipmap_.use();
    for (std::size_t level = 0; level + 1 < levels_.size(); ++level) {
        const int finer = static_cast<int>(level);
        voxels.bindLevel(VCT_IMAGE_VOXELS, finer, GL_READ_ONLY);
        voxels.bindLevel(VCT_IMAGE_VOXELS_NEXT, finer + 1, GL_READ_WRITE);
        dispatchOverStill(level, added_[level], voxels);
        // What moves finds every parent that is listed already.
        gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        dispatchFrom(firstMoving(level), level, voxels);
        gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    }
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT |
                      GL_COMMAND_BARRIER_BIT);
}

void PartialVoxels::dispatchOverStill(std::size_t level, const Range& range,
                                      const VoxelPyramid& voxels) const {
    if (range.first == range.end) return;
    voxels.bindLists();
    stillVoxels_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_ACTIVE_VOXELS);
    gl::Uniform1ui(VCT_UNIFORM_LEVEL, static_cast<GLuint>(level));
    gl::Uniform1ui(VCT_UNIFORM_FIRST, range.first);
    gl::Uniform1ui(VCT_UNIFORM_END, range.end);
    gl::DispatchCompute(std::min((range.end - range.first - 1) / VCT_LIST_GROUP + 1, mostGroups), 1, 1);
}

std::uint32_t PartialVoxels::firstMoving(std::size_t level) const {
    return levels_[level].firstEntry + static_cast<std::uint32_t>(levels_[level].entries.size());
}

// To the end of the level's list, which the GPU alone knows.
void PartialVoxels::dispatchFrom(std::uint32_t entry, std::size_t level, const VoxelPyramid& voxels) const {
    voxels.bindLists();
    gl::Uniform1ui(VCT_UNIFORM_LEVEL, static_cast<GLuint>(level));
    gl::Uniform1ui(VCT_UNIFORM_FIRST, entry);
    gl::Uniform1ui(VCT_UNIFORM_END, 0);
    constexpr GLuint groups = 32;
    gl::DispatchCompute(groups, 1, 1);
}

}  // namespace vct
