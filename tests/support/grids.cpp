#include "support/grids.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "gl/read_back.h"
#include "lab/cpu_mips.h"

namespace vct::test {

namespace {

// The words of each face, summed over static geometry and dynamic objects.
std::map<std::uint32_t, std::vector<std::uint32_t>> sumsOf(const DirectionalVoxels& voxels) {
    std::vector<std::uint32_t> words(voxels.faceData().bytes() / sizeof(std::uint32_t));
    voxels.faceData().read(words.data(), voxels.faceData().bytes());
    const shared::CommandLists commands = voxels.index().readCommands();
    std::map<std::uint32_t, std::vector<std::uint32_t>> sums;
    for (const std::uint32_t list : {voxels.staticList(), voxels.dynamicList()}) {
        const shared::LevelCommands& base = commands.lists[list];
        for (std::uint32_t i = 0; i < base.faceCount; ++i) {
            const std::uint32_t entry = words.at(base.firstFace + i) & ~VCT_MERGED_FACE;
            const std::uint32_t* const face = &words.at(std::size_t{base.firstId + i} * voxels.faceWords());
            std::vector<std::uint32_t>& sum = sums[entry];
            sum.resize(voxels.faceWords() - 1);  // the surface is found when light is injected
            sum[0] = std::max(sum[0], face[1]);  // the plane of the surface that covers most
            for (std::uint32_t word = 1; word < sum.size(); ++word)
                sum[word] += face[word + 1];
        }
    }
    return sums;
}

// The coverage of listed faces; the others must be empty.
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
        grid.sums = sumsOf(voxels);
        grid.hasIrradiance = renderer.directional()->irradiance(GatherPurpose::light) != nullptr;
    }
    return grid;
}

void expectSameGrid(const Grid& a, const Grid& b, const std::string& what) {
    EXPECT_EQ(a.lists[0].size(), b.lists[0].size()) << what;
    EXPECT_TRUE(a.lists == b.lists) << what << ": other voxels are occupied";
    EXPECT_TRUE(a.words == b.words) << what << ": words differ";
    for (std::size_t level = 0; level < std::min(a.faceLists.size(), b.faceLists.size()); ++level)
        EXPECT_TRUE(a.faceLists[level] == b.faceLists[level])
            << what << ": other faces are listed at level " << level << ", " << a.faceLists[level].size()
            << " against " << b.faceLists[level].size();
    EXPECT_TRUE(a.sums == b.sums) << what << ": coverage, albedo, emission or plane differ";
    EXPECT_TRUE(coverageOf(a) == coverageOf(b)) << what << ": what faces cover differs";
    if (a.hasIrradiance || b.hasIrradiance) return;
    // Sums of static and of dynamic geometry are rounded before they are added.
    for (std::size_t level = 0; level < std::min(a.faces.size(), b.faces.size()); ++level)
        EXPECT_LE(maxDifference(a.faces[level], b.faces[level]), 1) << what << ": radiance, level " << level;
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
