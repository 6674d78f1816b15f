// All that voxelization leaves behind, and whether two renderers left the same.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/renderer.h"
#include "support/faces.h"

namespace vct::test {

// Slots are in whatever order the GPU took them, so not compared.
struct Grid {
    std::vector<std::vector<std::uint32_t>> lists;      // of each level, sorted
    std::vector<std::vector<std::uint32_t>> words;      // of each level; of the one kind of voxels
    std::vector<FaceLevel> faces;                       // or of the other
    std::vector<std::vector<std::uint32_t>> faceLists;  // as the lists of voxels
    // And what voxelization added up: of each listed voxel which faces are not empty, and their words.
    std::map<std::uint32_t, std::vector<std::uint32_t>> sums;
    bool received =
        false;  // whether the faces shine with what they received, too, which no frame alone determines
};
Grid gridOf(Renderer& renderer);

// Bit for bit, but for received light; not EXPECT_EQ, which would print millions of words.
void expectSameGrid(const Grid& a, const Grid& b, const std::string& what);

// The grid is equal to the last bit, and each pixel's light is added up in the same order.
void expectSamePicture(const Image& a, const Image& b, const std::string& what);

}  // namespace vct::test
