#include "support/grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gl/read_back.h"
#include "lab/cpu_mips.h"

namespace vct::test {

namespace {

std::vector<std::uint32_t> wordsOf(const gl::Buffer& buffer) {
    std::vector<std::uint32_t> words(buffer.bytes() / sizeof(std::uint32_t));
    if (!words.empty()) buffer.read(words.data(), buffer.bytes());
    return words;
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

// True if surfaces are the same but for rounding. A face that static and dynamic geometry share is computed
// from the rounded words of the static surface.
bool areAlike(const Face& one, const Face& other) {
    return std::abs(one.coverage - other.coverage) < 0.01 &&
           glm::all(glm::lessThan(glm::abs(one.albedo - other.albedo), glm::dvec3(0.01))) &&
           one.normal == other.normal && one.offset == other.offset;
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
    }
    return grid;
}

void expectSameGrid(const Grid& a, const Grid& b, const std::string& what) {
    EXPECT_EQ(a.lists[0].size(), b.lists[0].size()) << what;
    EXPECT_TRUE(a.lists == b.lists) << what << ": other voxels are occupied";
    EXPECT_TRUE(a.words == b.words) << what << ": words differ";
    EXPECT_TRUE(a.blockFaces == b.blockFaces) << what << ": other faces of blocks are listed";
    // Opacity is left out: a static surface ends at other static ones alone, so that its hits can be kept.
    EXPECT_EQ(a.faces.size(), b.faces.size()) << what;
    std::size_t others = 0;
    for (const auto& [entry, face] : a.faces) {
        const auto found = b.faces.find(entry);
        if (found == b.faces.end() || !areAlike(face, found->second)) ++others;
    }
    EXPECT_LE(others, a.faces.size() / 2000) << what << ": surfaces differ";
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
