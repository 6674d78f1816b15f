// Places for meshes that come and go in a buffer: the first free range that is large enough.
#pragma once

#include <cstddef>
#include <map>
#include <optional>

namespace vct {

class Ranges {
  public:
    // All elements below `used` are taken for ever.
    explicit Ranges(std::size_t used = 0) : capacity_(used) {}

    // The first element of a range of `count` elements, which is taken until release(); none if no free range
    // is that large.
    std::optional<std::size_t> allocate(std::size_t count);
    void release(std::size_t first, std::size_t count);
    // Adds free elements at the end.
    void grow(std::size_t capacity);
    std::size_t capacity() const { return capacity_; }

  private:
    std::size_t capacity_;
    std::map<std::size_t, std::size_t> free_;  // counts by first element; no two ranges touch
};

}  // namespace vct
