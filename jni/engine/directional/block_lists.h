// What the static geometry occupies, in lists that are sorted by block: what lies in some blocks is visited
// alone. Of a scene where something else moves.
#pragma once

#include <string>
#include <vector>

#include "engine/directional/dirty_blocks.h"
#include "gl/objects.h"

namespace vct {

class BlockLists {
  public:
    // Of a level with `side` voxels along each side, in entries that `voxelOf` understands. Where voxels are
    // larger than blocks they stay in the order in which they are.
    struct List {
        std::vector<std::uint32_t> entries;
        int side;
        glm::uvec3 (*voxelOf)(std::uint32_t entry);
    };
    BlockLists(const std::string& label, std::vector<List> lists);

    std::size_t size() const { return lists_.size(); }
    bool isInBlocks(std::size_t list) const { return !lists_[list].firstOfBlock.empty(); }
    std::uint32_t count(std::size_t list) const {
        return static_cast<std::uint32_t>(lists_[list].entries.size());
    }

    // What this frame makes anew; null: everything. Also binds it for shaders
    // (directional/dirty_blocks.glsl).
    void choose(const BlockMask* changed);

    // Of entries, in buffers that hold them one behind the other.
    struct Range {
        std::uint32_t first = 0, end = 0;
    };
    Range all(std::size_t list) const;
    // Of those that were chosen; all where voxels are larger than blocks.
    Range chosen(std::size_t list) const { return chosen_[list]; }
    // What moves, in the level's own list.
    struct Moving {
        std::uint32_t first = VCT_NO_ENTRY;  // VCT_NO_ENTRY: none of it
        // How many there may be, as the GPU alone knows: so many invocations, each of which takes as many
        // entries as there are for it.
        std::uint32_t about = 2048;
    };
    // Runs the current program, one that was compiled with VCT_PART, over both in one dispatch.
    void dispatchOver(const Range& still, const Moving& moving, std::size_t level) const;

    std::vector<const gl::Buffer*> buffers() const { return {&entries_, &mask_}; }

  private:
    struct Sorted {
        std::vector<std::uint32_t> entries;
        std::vector<std::uint32_t> firstOfBlock;  // and behind the last; empty where a voxel is larger
        std::uint32_t first = 0;                  // in entries_
    };
    std::vector<Sorted> lists_;
    std::vector<Range> chosen_;
    std::uint32_t firstCopied_ = 0;
    gl::Buffer entries_;  // of all lists; behind them, those that were chosen
    gl::Buffer mask_;
};

}  // namespace vct
