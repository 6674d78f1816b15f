#include "engine/ranges.h"

#include <algorithm>
#include <iterator>

namespace vct {

std::optional<std::size_t> Ranges::allocate(std::size_t count) {
    const auto found =
        std::find_if(free_.begin(), free_.end(), [&](const auto& range) { return range.second >= count; });
    if (found == free_.end()) return {};
    const auto [first, room] = *found;
    free_.erase(found);
    if (room > count) free_.emplace(first + count, room - count);
    return first;
}

void Ranges::release(std::size_t first, std::size_t count) {
    auto at = free_.emplace(first, count).first;
    if (const auto next = std::next(at); next != free_.end() && first + count == next->first) {
        at->second += next->second;
        free_.erase(next);
    }
    if (at == free_.begin()) return;
    const auto before = std::prev(at);
    if (before->first + before->second != first) return;
    before->second += at->second;
    free_.erase(at);
}

void Ranges::grow(std::size_t capacity) {
    release(capacity_, capacity - capacity_);
    capacity_ = capacity;
}

}  // namespace vct
