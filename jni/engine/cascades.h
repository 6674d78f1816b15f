// Nested cubes of voxels around the camera, for scenes too large for one cube (docs/voxel-cone-tracing.md,
// "Large scenes"). Cascade 0 is the finest. Each cascade has as many voxels as the others and is twice as
// wide as the one before. The last one is the volume itself and does not move.
#pragma once

#include <algorithm>
#include <array>
#include <glm/glm.hpp>

#include "shared/layout.h"

namespace vct {

class Cascades {
  public:
    // `count`: 1 to VCT_MAX_CASCADES. `grid`: voxels along a side of each cascade.
    Cascades(int count, int grid);

    int count() const { return count_; }
    // Side of a cascade, in sides of the volume.
    double side(int cascade) const;
    // The corner of a cascade with the smallest coordinates, volume space.
    const glm::dvec3& corner(int cascade) const { return corners_[static_cast<std::size_t>(cascade)]; }

    // Centres the cascades on the eye (volume space), in steps of their own bricks of eight voxels, so that
    // their voxels stay in place. A cascade moves once the eye is more than 3/4 of a step from its centre, so
    // that an eye at the border of two steps does not move it back and forth. In one
    // call only the cascade farthest from its place moves, which bounds the cost of a frame. After a jump,
    // every cascade that is 1 1/2 steps away moves, so that each stays inside of the next. Returns true if
    // any has moved.
    bool follow(const glm::dvec3& eye);

    // The cascade around which a tile of the sun's shadow map is drawn.
    int ofShadowTile(int tile) const { return std::max(count_ - VCT_SHADOW_TILES + tile, 0); }

    bool operator==(const Cascades& other) const { return corners_ == other.corners_; }

  private:
    static constexpr int brickVoxels = 8;

    int count_, grid_;
    std::array<glm::dvec3, VCT_MAX_CASCADES> corners_{};
    bool isPlaced_ = false;
};

}  // namespace vct
