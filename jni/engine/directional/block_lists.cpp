#include "engine/directional/block_lists.h"

#include <algorithm>

namespace vct {

namespace {

constexpr std::size_t blockCount = BlockMask::side * BlockMask::side * BlockMask::side;

std::size_t blockOf(const glm::uvec3& voxel, int levelSide) {
    const glm::uvec3 block =
        voxel * static_cast<unsigned>(BlockMask::side) / static_cast<unsigned>(levelSide);
    return block.x + BlockMask::side * (block.y + std::size_t{BlockMask::side} * block.z);
}

// Sorts the entries by block; returns where each block's begin, and behind the last.
std::vector<std::uint32_t> sortByBlock(BlockLists::List& list) {
    std::vector<std::uint32_t> first(blockCount + 1);
    for (const std::uint32_t entry : list.entries)
        ++first[blockOf(list.voxelOf(entry), list.side) + 1];
    for (std::size_t block = 0; block < blockCount; ++block)
        first[block + 1] += first[block];
    std::vector<std::uint32_t> next = first, sorted(list.entries.size());
    for (const std::uint32_t entry : list.entries)
        sorted[next[blockOf(list.voxelOf(entry), list.side)]++] = entry;
    list.entries = std::move(sorted);
    return first;
}

}  // namespace

BlockLists::BlockLists(const std::string& label, std::vector<List> lists)
    : mask_("dirty blocks", GL_UNIFORM_BUFFER, blockCount / 8, nullptr, GL_DYNAMIC_DRAW) {
    std::vector<std::uint32_t> all;
    std::size_t inBlocks = 0;  // which are copied behind the others, where they are chosen
    for (List& list : lists) {
        Sorted& sorted = lists_.emplace_back();
        if (list.side >= BlockMask::side) {
            sorted.firstOfBlock = sortByBlock(list);
            inBlocks += list.entries.size();
        }
        sorted.first = static_cast<std::uint32_t>(all.size());
        sorted.entries = std::move(list.entries);
        all.insert(all.end(), sorted.entries.begin(), sorted.entries.end());
    }
    firstCopied_ = static_cast<std::uint32_t>(all.size());
    all.resize(std::max<std::size_t>(all.size() + inBlocks, 1));
    entries_ =
        gl::Buffer(label, GL_SHADER_STORAGE_BUFFER, all.size() * sizeof all[0], all.data(), GL_DYNAMIC_DRAW);
}

BlockLists::Range BlockLists::all(std::size_t list) const {
    return {lists_[list].first, lists_[list].first + count(list)};
}

void BlockLists::choose(const BlockMask* changed) {
    const BlockMask mask = changed != nullptr ? *changed : BlockMask::all();
    mask_.bind(GL_UNIFORM_BUFFER);
    gl::BufferSubData(GL_UNIFORM_BUFFER, 0, static_cast<GLsizeiptr>(mask_.bytes()), mask.rows().data());
    mask_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_DIRTY_BLOCKS);

    chosen_.clear();
    std::vector<std::uint32_t> copied;
    const std::vector<std::uint32_t> blocks =
        changed != nullptr ? changed->blocks() : std::vector<std::uint32_t>();
    for (std::size_t i = 0; i < lists_.size(); ++i) {
        chosen_.push_back(all(i));
        if (changed == nullptr || !isInBlocks(i)) continue;
        const Sorted& list = lists_[i];
        chosen_[i].first = firstCopied_ + static_cast<std::uint32_t>(copied.size());
        for (const std::uint32_t block : blocks)
            copied.insert(copied.end(), list.entries.begin() + list.firstOfBlock[block],
                          list.entries.begin() + list.firstOfBlock[block + 1]);
        chosen_[i].end = firstCopied_ + static_cast<std::uint32_t>(copied.size());
    }
    if (copied.empty()) return;
    entries_.bind(GL_COPY_WRITE_BUFFER);
    gl::BufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(firstCopied_ * sizeof copied[0]),
                      static_cast<GLsizeiptr>(copied.size() * sizeof copied[0]), copied.data());
}

void BlockLists::dispatchOver(const Range& chosen, const Moving& moving, std::size_t level) const {
    const std::uint32_t entries = chosen.end - chosen.first + std::max(moving.about, 1U);
    entries_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_STATIC_ENTRIES);
    gl::Uniform1ui(VCT_UNIFORM_LEVEL, static_cast<GLuint>(level));
    gl::Uniform1ui(VCT_UNIFORM_FIRST, chosen.first);
    gl::Uniform1ui(VCT_UNIFORM_END, chosen.end);
    gl::Uniform1ui(VCT_UNIFORM_MOVING, moving.first);
    // Enough to keep a GPU busy; each invocation takes as many entries as there are for it.
    constexpr GLuint mostGroups = 1024;
    gl::DispatchCompute(std::min((entries - 1) / VCT_LIST_GROUP + 1, mostGroups), 1, 1);
}

}  // namespace vct
