// Places in a buffer for meshes that come and go.
#include "engine/ranges.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace vct::test {
namespace {

TEST(Ranges, TakeNothingTwiceAndLoseNothing) {
    constexpr std::size_t fixed = 10, capacity = 200;
    Ranges ranges(fixed);
    EXPECT_EQ(ranges.allocate(1), std::nullopt);
    ranges.grow(capacity);
    struct Piece {
        std::size_t first, count;
    };
    std::vector<Piece> taken;
    std::mt19937 random(1);
    for (int i = 0; i < 3000; ++i) {
        if (random() % 2 == 0 && !taken.empty()) {
            const std::size_t which = random() % taken.size();
            ranges.release(taken[which].first, taken[which].count);
            taken.erase(taken.begin() + static_cast<std::ptrdiff_t>(which));
        } else {
            const std::size_t count = 1 + random() % 30;
            const std::optional<std::size_t> first = ranges.allocate(count);
            if (!first) continue;
            ASSERT_GE(*first, fixed);
            ASSERT_LE(*first + count, capacity);
            for (const Piece& other : taken)
                ASSERT_TRUE(*first + count <= other.first || other.first + other.count <= *first);
            taken.push_back({*first, count});
        }
    }
    for (const Piece& range : taken)
        ranges.release(range.first, range.count);
    EXPECT_EQ(ranges.allocate(capacity - fixed), fixed) << "a free range was lost";
}

}  // namespace
}  // namespace vct::test
