// Names and sizes of GPU objects, for reports of memory use.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace vct {

struct Resource {
    std::string name;
    std::size_t bytes;
};
using Resources = std::vector<Resource>;

// `object` is a gl::Texture or a gl::Buffer.
template <typename Object>
void add(Resources& resources, const Object& object) {
    resources.push_back({object.label(), object.bytes()});
}

inline void add(Resources& resources, const Resources& others) {
    resources.insert(resources.end(), others.begin(), others.end());
}

}  // namespace vct
