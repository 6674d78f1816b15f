#include "support/grids.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "measure/cpu_mips.h"
#include "render/read_back.h"

namespace vct::test {

Grid gridOf(Renderer& renderer) {
    Grid grid;
    const VoxelPyramid& pyramid =
        renderer.voxels() != nullptr ? *renderer.voxels() : renderer.faceVoxels()->slots();
    const std::vector<std::uint32_t> counts = pyramid.readActiveCounts();
    for (int level = 0; level < pyramid.levels(); ++level) {
        grid.lists.push_back(readEntries(pyramid, level, counts[static_cast<std::size_t>(level)]));
        std::sort(grid.lists.back().begin(), grid.lists.back().end());
        if (renderer.voxels() != nullptr) grid.words.push_back(readVoxels(pyramid.texture(), level));
    }
    if (const FaceVoxels* voxels = renderer.faceVoxels()) {
        grid.faces = readFaces(*voxels);
        for (int level = 0; level < voxels->levels(); ++level) {
            grid.faceLists.push_back(voxels->readFaceList(level));
            std::sort(grid.faceLists.back().begin(), grid.faceLists.back().end());
        }
    }
    return grid;
}

void expectSameGrid(const Grid& a, const Grid& b, const std::string& what) {
    EXPECT_EQ(a.lists[0].size(), b.lists[0].size()) << what;
    EXPECT_TRUE(a.lists == b.lists) << what << ": other voxels are occupied";
    EXPECT_TRUE(a.words == b.words) << what << ": words differ";
    EXPECT_TRUE(a.faces == b.faces) << what << ": faces differ";
    EXPECT_TRUE(a.faceLists == b.faceLists) << what << ": other faces are listed";
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
