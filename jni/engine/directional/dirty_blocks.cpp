#include "engine/directional/dirty_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vct {

namespace {

Bounds moved(const Bounds& box, const glm::dvec3& by) {
    return {box.min + by, box.max + by};
}

bool isEmpty(const Bounds& box) {
    return !glm::all(glm::lessThanEqual(box.min, box.max));
}

// The blocks from `first` to `last`, both included; none where the box is outside the volume.
struct BlockRange {
    glm::ivec3 first, last;
    explicit BlockRange(const Bounds& box) {
        // Clamped before they become whole numbers, which a box far outside would not fit into.
        const double end = BlockMask::side;
        first = glm::ivec3(glm::floor(glm::clamp(box.min * end, 0.0, end)));
        last = glm::ivec3(glm::floor(glm::clamp(box.max * end, -1.0, end - 1.0)));
    }
    template <typename Visit>
    void forEachRow(Visit&& visit) const {
        if (first.x > last.x) return;
        const std::uint64_t bits = (std::uint64_t{1} << (last.x + 1)) - (std::uint64_t{1} << first.x);
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y)
                visit(static_cast<std::size_t>(z * BlockMask::side + y), static_cast<std::uint32_t>(bits));
    }
};

// What `box` sweeps on its way from the light, as far as `shadow.staticBox` goes.
void addShadow(BlockMask& mask, const Bounds& box, const ShadowReach& shadow) {
    const glm::dvec3 away = -shadow.towardsLight;
    double begin = -shadow.above, end = std::numeric_limits<double>::max();
    for (int axis = 0; axis < 3; ++axis) {
        const double toFar = shadow.staticBox.max[axis] - box.min[axis];
        const double toNear = shadow.staticBox.min[axis] - box.max[axis];
        if (away[axis] == 0.0) {
            if (toFar < 0.0 || toNear > 0.0) return;
            continue;
        }
        const auto [first, last] = std::minmax({toFar / away[axis], toNear / away[axis]});
        begin = std::max(begin, first);
        end = std::min(end, last);
    }
    constexpr double step = 1.0 / BlockMask::side;
    for (double at = begin; at <= end; at += step) {
        Bounds swept = united(moved(box, away * at), moved(box, away * (at + step)));
        swept.min = glm::max(swept.min, shadow.staticBox.min);
        swept.max = glm::min(swept.max, shadow.staticBox.max);
        if (!isEmpty(swept)) mask.add(swept);
    }
}

}  // namespace

BlockMask BlockMask::all() {
    BlockMask mask;
    mask.rows_.fill(~0U);
    return mask;
}

void BlockMask::add(const Bounds& box) {
    BlockRange(box).forEachRow([&](std::size_t row, std::uint32_t bits) { rows_[row] |= bits; });
}

bool BlockMask::touches(const Bounds& box) const {
    std::uint32_t found = 0;
    BlockRange(box).forEachRow([&](std::size_t row, std::uint32_t bits) { found |= rows_[row] & bits; });
    return found != 0;
}

Bounds BlockMask::box() const {
    Bounds box = boundsOf({}, glm::dmat4(1.0));
    for (const std::uint32_t block : blocks()) {
        const glm::dvec3 corner(block % side, block / side % side, block / (side * side));
        box = united(box, {corner / double{side}, (corner + 1.0) / double{side}});
    }
    return box;
}

std::vector<std::uint32_t> BlockMask::blocks() const {
    std::vector<std::uint32_t> blocks;
    for (std::size_t row = 0; row < rows_.size(); ++row)
        for (std::size_t x = 0; x < side && rows_[row] >> x != 0; ++x)
            if ((rows_[row] >> x & 1U) != 0) blocks.push_back(static_cast<std::uint32_t>(row * side + x));
    return blocks;
}

Bounds grown(const Bounds& box, double by) {
    return {box.min - by, box.max + by};
}

// By the balls around both, so a little too many.
void addShadow(BlockMask& mask, const Bounds& box, const PlacedLight& light) {
    const glm::dvec3 towardsBox = 0.5 * (box.min + box.max) - light.place;
    const double distance = glm::length(towardsBox);
    const double radius = 0.5 * glm::length(box.max - box.min);
    const double blockRadius = std::sqrt(3.0) / 2.0 / BlockMask::side;
    const auto halfAngle = [](double size, double away) {
        return size < away ? std::asin(size / away) : 4.0;
    };
    const double ofBox = halfAngle(radius, distance) + light.angle;
    for (int z = 0; z < BlockMask::side; ++z)
        for (int y = 0; y < BlockMask::side; ++y)
            for (int x = 0; x < BlockMask::side; ++x) {
                const glm::dvec3 block = (glm::dvec3(x, y, z) + 0.5) / double{BlockMask::side};
                const glm::dvec3 towards = block - light.place;
                const double away = glm::length(towards);
                const double reach = ofBox + halfAngle(blockRadius, away);
                const double cosine = glm::dot(towards, towardsBox) / std::max(away * distance, 1e-30);
                if (reach >= 3.15 || cosine >= std::cos(reach)) mask.add({block, block});
            }
}

BlockMask dirtyBlocks(const std::vector<Placement>& before, const std::vector<Placement>& after,
                      const ShadowReach& shadow, double voxel) {
    const double snapped = snappingReach(voxel);
    BlockMask mask;
    ShadowReach reach = shadow;
    reach.staticBox = grown(shadow.staticBox, snapped);
    for (std::size_t i = 0; i < after.size(); ++i) {
        const bool changed = !(before[i] == after[i]);
        for (const Placement* placement : {&before[i], &after[i]}) {
            mask.add(grown(placement->box, snapped));
            if (changed && !isEmpty(reach.staticBox))
                addShadow(mask, grown(placement->box, snapped + shadow.margin), reach);
        }
    }
    return mask;
}

}  // namespace vct
