#include "lab/cpu_mips.h"

#include <algorithm>

namespace vct {

Words mipOnCpu(const Words& words, int side) {
    const int half = side / 2;
    Words parents(static_cast<std::size_t>(half) * half * half, 0U);
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const std::uint32_t word = words[(static_cast<std::size_t>(z) * side + y) * side + x];
                if (word == 0U) continue;
                parents[(static_cast<std::size_t>(z / 2) * half + y / 2) * half + x / 2] +=
                    shared::childContribution(word);
            }
    return parents;
}

std::vector<std::uint32_t> entriesOnCpu(const Words& words, int side) {
    std::vector<std::uint32_t> entries;
    std::size_t index = 0;
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                if (words[index++] != 0U) entries.push_back(shared::packEntry({x, y, z}));
    std::sort(entries.begin(), entries.end());
    return entries;
}

std::vector<std::uint32_t> readEntries(const VoxelPyramid& pyramid, int level, std::uint32_t count) {
    std::vector<std::uint32_t> entries(pyramid.firstEntry(level) + count);
    pyramid.activeVoxels().read(entries.data(), entries.size() * sizeof entries[0]);
    return {entries.end() - count, entries.end()};
}

}  // namespace vct
