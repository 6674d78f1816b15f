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
    // What voxelization added up for each face of the base level.
    std::map<std::uint32_t, std::vector<std::uint32_t>> sums;
    bool received = false;  // the faces also reflect their irradiance, which no frame alone determines
};
Grid gridOf(Renderer& renderer);

// Lists and sums bit for bit, radiance to a step of 8 bits; not EXPECT_EQ, which would print millions of
// words.
void expectSameGrid(const Grid& a, const Grid& b, const std::string& what);

// The grid is equal to the last bit, and each pixel's light is added up in the same order.
void expectSamePicture(const Image& a, const Image& b, const std::string& what);

}  // namespace vct::test
