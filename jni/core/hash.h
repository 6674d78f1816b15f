// FNV-1a, of 64 bits (Fowler, Noll and Vo): a hash that finds accidental changes of data.
#pragma once

#include <cstddef>
#include <cstdint>

namespace vct {

constexpr std::uint64_t fnvBasis = 0xCBF29CE484222325U;

inline std::uint64_t fnv1a(const void* data, std::size_t size, std::uint64_t hash = fnvBasis) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i)
        hash = (hash ^ bytes[i]) * 0x100000001B3U;
    return hash;
}

}  // namespace vct
