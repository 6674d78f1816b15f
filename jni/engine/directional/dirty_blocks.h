// Which voxels another pose can change: those that what moves leaves or enters, and those that its shadow
// does.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "scene/deformation.h"
#include "shared/layout.h"

namespace vct {

// A bit for each of 32^3 blocks of the volume; boxes are in volume space, and so is every length here.
class BlockMask {
  public:
    static constexpr int side = VCT_BLOCKS;

    static BlockMask all();
    // The blocks that the box touches.
    void add(const Bounds& box);
    bool touches(const Bounds& box) const;
    // Around all of them; inverted where there are none.
    Bounds box() const;
    std::vector<std::uint32_t> blocks() const;  // x + side * (y + side * z) of each

    // A word of bits along x for each y, for each z: as shaders/directional/dirty_blocks.glsl reads them.
    const std::array<std::uint32_t, side * side>& rows() const { return rows_; }

  private:
    std::array<std::uint32_t, side * side> rows_{};
};

// An instance that can move.
struct Placement {
    glm::dmat4 worldFromObject{1.0};
    Bounds box;                                              // around it
    std::shared_ptr<const DeformationState> form = nullptr;  // null where it keeps its form

    bool operator==(const Placement& other) const {
        return worldFromObject == other.worldFromObject &&
               (form == other.form || (form != nullptr && other.form != nullptr && *form == *other.form));
    }
};

struct ShadowReach {
    glm::dvec3 towardsLight;
    double margin;     // how far beside its own projection something can change the filtered shadow
    double above;      // and how far towards the light
    Bounds staticBox;  // around what can be in shadow and does not move
};

// How far a rasterizer may move fragments out of a box: it snaps corners to the next 1/16 of a pixel or finer
// (SUBPIXEL_BITS is at least 4). `voxel`: a voxel's side.
constexpr double snappingReach(double voxel) {
    return voxel / 4.0;
}
Bounds grown(const Bounds& box, double by);

// A light that has a place casts the shadow of a box into all blocks behind and beside it, as seen from
// there.
struct PlacedLight {
    glm::dvec3 place;
    double angle;  // radians: how far beside its own projection something can change the filtered shadow
};
// Adds those blocks. 32768 of them are looked at.
void addShadow(BlockMask& mask, const Bounds& box, const PlacedLight& light);

// `before` and `after` hold the same instances. Those that have not moved count too, as all that can move is
// removed and put in again, but not their shadows. `voxel`: a voxel's side.
BlockMask dirtyBlocks(const std::vector<Placement>& before, const std::vector<Placement>& after,
                      const ShadowReach& shadow, double voxel);

}  // namespace vct
