#include "support/voxels.h"

namespace vct::test {

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

void writeLevel(const gl::Texture& voxels, int level, const Words& words) {
    const int side = voxels.width() >> level;
    voxels.bind(VCT_TEX_VOXELS);
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl::TexSubImage3D(GL_TEXTURE_3D, level, 0, 0, 0, side, side, side, GL_RED_INTEGER, GL_UNSIGNED_INT,
                      words.data());
}

void writePyramid(const gl::Texture& voxels, Words base) {
    for (int level = 0; level < voxels.levels(); ++level) {
        writeLevel(voxels, level, base);
        if (level + 1 < voxels.levels()) base = mipOnCpu(base, voxels.width() >> level);
    }
}

std::vector<std::uint32_t> readEntries(const VoxelPyramid& pyramid, int level, std::uint32_t count) {
    std::vector<std::uint32_t> entries(pyramid.firstEntry(level) + count);
    pyramid.activeVoxels().read(entries.data(), entries.size() * sizeof entries[0]);
    return {entries.end() - count, entries.end()};
}

}  // namespace vct::test
