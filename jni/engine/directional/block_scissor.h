// Limits voxelization to the pixels that some blocks of the volume are projected to (shared/projection.glsl).
#pragma once

#include <array>

#include "engine/directional/dirty_blocks.h"

namespace vct {

// Of draws to come, while it lives and after one of its functions.
class BlockScissor {
  public:
    // `viewport`: of the projected volume, as glViewport takes it.
    BlockScissor(const BlockMask& blocks, const glm::ivec4& viewport);
    ~BlockScissor();
    BlockScissor(const BlockScissor&) = delete;
    BlockScissor& operator=(const BlockScissor&) = delete;

    void along(std::size_t axis) const;
    void alongAnyAxis() const;

  private:
    std::array<glm::ivec4, 3> pixels_;  // along each axis: x, y, and behind the last ones
};

}  // namespace vct
