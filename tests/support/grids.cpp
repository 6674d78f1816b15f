#include "support/grids.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "gl/read_back.h"
#include "lab/cpu_mips.h"

namespace vct::test {

namespace {

std::vector<std::uint32_t> wordsOf(const gl::Buffer& buffer) {
    std::vector<std::uint32_t> words(buffer.bytes() / sizeof(std::uint32_t));
    if (!words.empty()) buffer.read(words.data(), buffer.bytes());
    return words;
}

// The sums of each face, over static geometry and dynamic objects.
std::map<std::uint32_t, std::vector<std::uint32_t>> sumsOf(const DirectionalVoxels& voxels) {
    const std::vector<std::uint32_t> words = wordsOf(voxels.faceData()), all = wordsOf(voxels.faceSums());
    const shared::CommandLists commands = voxels.index().readCommands();
    std::map<std::uint32_t, std::vector<std::uint32_t>> sums;
    if (all.empty()) return sums;
    for (const std::uint32_t list : {0U, voxels.dynamicList()}) {
        const shared::LevelCommands& base = commands.lists[list];
        for (std::uint32_t i = 0; i < std::min<std::uint32_t>(base.faceCount, base.faceCapacity); ++i) {
            std::uint32_t entry = words.at(base.firstFace + i);
            if (entry == VCT_FREE_FACE) continue;
            entry &= ~(VCT_MERGED_FACE | VCT_FIRST_FACE);
            std::vector<std::uint32_t>& sum = sums[entry];
            // shaders/directional/face_sums.glsl: two planes and an albedo, then sums.
            const std::uint32_t* const face = &all.at(std::size_t{base.firstId + i} * voxels.sumWords());
            sum.resize(voxels.sumWords());
            for (std::uint32_t word = 0; word < sum.size(); ++word)
                sum[word] = word < 3 ? std::max(sum[word], face[word]) : sum[word] + face[word];
        }
    }
    return sums;
}

// The words of each face that resolve.comp and extents.comp make from the sums.
std::map<std::uint32_t, std::vector<std::uint32_t>> surfacesOf(const DirectionalVoxels& voxels) {
    const std::vector<std::uint32_t> words = wordsOf(voxels.faceData());
    std::map<std::uint32_t, std::vector<std::uint32_t>> surfaces;
    for (const auto& [entry, id] : voxels.readBaseFaces()) {
        const auto first = words.begin() + voxels.faceWord(id);
        surfaces[entry].assign(first, first + voxels.faceWords());
    }
    return surfaces;
}

}  // namespace

Grid gridOf(Renderer& renderer) {
    Grid grid;
    const VoxelPyramid& pyramid = renderer.occupancy();
    const std::vector<std::uint32_t> counts = pyramid.readActiveCounts();
    for (int level = 0; level < pyramid.levels(); ++level) {
        if (renderer.packed() == nullptr) continue;
        grid.lists.push_back(readEntries(pyramid, level, counts[static_cast<std::size_t>(level)]));
        std::sort(grid.lists.back().begin(), grid.lists.back().end());
        grid.words.push_back(readVoxels(pyramid.texture(), level));
    }
    if (renderer.directional() != nullptr) {
        const DirectionalVoxels& voxels = renderer.directional()->voxels();
        grid.lists.push_back(voxels.readVoxels());
        EXPECT_EQ(counts.at(0), grid.lists[0].size());
        grid.faces = readFaces(voxels);
        grid.blockFaces = voxels.readBlockFaces();
        std::sort(grid.blockFaces.begin(), grid.blockFaces.end());
        grid.surfaces = surfacesOf(voxels);
        grid.sums = sumsOf(voxels);
    }
    return grid;
}

void expectSameGrid(const Grid& a, const Grid& b, const std::string& what) {
    EXPECT_EQ(a.lists[0].size(), b.lists[0].size()) << what;
    EXPECT_TRUE(a.lists == b.lists) << what << ": other voxels are occupied";
    EXPECT_TRUE(a.words == b.words) << what << ": words differ";
    EXPECT_TRUE(a.blockFaces == b.blockFaces) << what << ": other faces of blocks are listed";
    const bool haveSums = !a.sums.empty() && !b.sums.empty();
    EXPECT_TRUE(!haveSums || a.sums == b.sums) << what << ": coverage, albedo, emission or plane differ";
    // Opacity is left out: a static surface ends at other static ones alone, so that its hits can be kept.
    const auto same = [](const Faces& one, const Faces& other) {
        return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                          [](const auto& x, const auto& y) {
                              return x.first == y.first && x.second.coverage == y.second.coverage &&
                                     x.second.normal == y.second.normal &&
                                     x.second.offset == y.second.offset && x.second.albedo == y.second.albedo;
                          });
    };
    EXPECT_TRUE(same(a.faces, b.faces)) << what << ": surfaces differ";
}

void expectSamePicture(const Image& a, const Image& b, const std::string& what) {
    ASSERT_EQ(a.pixels.size(), b.pixels.size()) << what;
    float largest = 0.0F;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::vec3 d = glm::abs(a.pixels[i] - b.pixels[i]);
        largest = std::max({largest, d.r, d.g, d.b});
    }
    EXPECT_LE(largest, 1e-3F) << what;
}

}  // namespace vct::test
