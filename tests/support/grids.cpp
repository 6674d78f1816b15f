#include "support/grids.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "gl/read_back.h"
#include "lab/cpu_mips.h"

namespace vct::test {

namespace {

std::map<std::uint32_t, std::vector<std::uint32_t>> sumsOf(const DirectionalVoxels& voxels,
                                                           std::uint32_t count) {
    const std::vector<std::uint32_t> entries = readEntries(voxels.index(), 0, count);
    std::vector<std::uint32_t> words(entries.size() * VCT_SLOT_WORDS);
    voxels.sums().read(words.data(), words.size() * sizeof words[0]);
    std::map<std::uint32_t, std::vector<std::uint32_t>> sums;
    for (std::size_t slot = 0; slot < entries.size(); ++slot) {
        const std::uint32_t* const first = &words[slot * VCT_SLOT_WORDS];
        // Which faces something static fills, is marked where something moves alone.
        const std::uint32_t glowing = *first >> (2 * VCT_FACE_MASK_BITS) & VCT_FACE_MASK;
        std::vector<std::uint32_t>& known = sums[entries[slot]];
        known = {*first & VCT_FACE_MASK, glowing};
        for (std::uint32_t face = 0; face < faceCount; ++face)
            if ((*first >> face & 1U) != 0)
                known.insert(known.end(), first + 1 + face * VCT_FACE_SUM_WORDS,
                             first + 1 + (face + 1) * VCT_FACE_SUM_WORDS);
    }
    return sums;
}

// Without the radiance of those faces that are listed: the others must be empty.
std::vector<FaceLevel> coverageOf(const Grid& grid) {
    std::vector<FaceLevel> faces = grid.faces;
    for (std::size_t level = 0; level < faces.size(); ++level)
        for (const std::uint32_t entry : grid.faceLists[level]) {
            glm::u8vec4& face = faces[level].at(glm::ivec3(shared::unpackFaceVoxel(entry)),
                                                static_cast<int>(shared::unpackFace(entry)));
            face = {0, 0, 0, face.a};
        }
    return faces;
}

}  // namespace

Grid gridOf(Renderer& renderer) {
    Grid grid;
    const VoxelPyramid& pyramid = renderer.occupancy();
    const std::vector<std::uint32_t> counts = pyramid.readActiveCounts();
    for (int level = 0; level < pyramid.levels(); ++level) {
        grid.lists.push_back(readEntries(pyramid, level, counts[static_cast<std::size_t>(level)]));
        std::sort(grid.lists.back().begin(), grid.lists.back().end());
        if (renderer.packed() != nullptr) grid.words.push_back(readVoxels(pyramid.texture(), level));
    }
    if (renderer.directional() != nullptr) {
        const DirectionalVoxels& voxels = renderer.directional()->voxels();
        grid.faces = readFaces(voxels);
        for (int level = 0; level < voxels.levels(); ++level) {
            grid.faceLists.push_back(voxels.readFaceList(level));
            std::sort(grid.faceLists.back().begin(), grid.faceLists.back().end());
        }
        grid.sums = sumsOf(voxels, counts[0]);
        grid.received = renderer.directional()->received(GatherOf::light) != nullptr;
    }
    return grid;
}

void expectSameGrid(const Grid& a, const Grid& b, const std::string& what) {
    EXPECT_EQ(a.lists[0].size(), b.lists[0].size()) << what;
    EXPECT_TRUE(a.lists == b.lists) << what << ": other voxels are occupied";
    EXPECT_TRUE(a.words == b.words) << what << ": words differ";
    EXPECT_TRUE(a.faceLists == b.faceLists) << what << ": other faces are listed";
    EXPECT_TRUE(a.sums == b.sums) << what << ": coverage, albedo, plane or direct light differ";
    const bool received = a.received || b.received;
    EXPECT_TRUE(received ? coverageOf(a) == coverageOf(b) : a.faces == b.faces) << what << ": faces differ";
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
