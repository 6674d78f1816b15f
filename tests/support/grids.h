// The voxels of a renderer, and their comparison.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/renderer.h"
#include "support/faces.h"

namespace vct::test {

// Slots are not compared, as the GPU assigns them in any order.
struct Grid {
    std::vector<std::vector<std::uint32_t>> lists;                 // of each level, sorted
    std::vector<std::vector<std::uint32_t>> words;                 // of each level of packed voxels
    Faces faces;                                                   // of directional voxels
    std::vector<std::uint32_t> blockFaces;                         // sorted
    std::map<std::uint32_t, std::vector<std::uint32_t>> surfaces;  // words of each face of the base level
};
Grid gridOf(Renderer& renderer);

// Lists and surfaces are equal to the bit. EXPECT_EQ would print millions of words.
void expectSameGrid(const Grid& a, const Grid& b, const std::string& what);

void expectSamePicture(const Image& a, const Image& b, const std::string& what);

}  // namespace vct::test
