// Comparison of a frame that two renderers drew.
#pragma once

#include <gtest/gtest.h>

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/string_cast.hpp>

#include "image/image.h"

namespace vct::test {

// With directional voxels the order of shader invocations decides the places of bricks. Coordinates in that
// texture round differently at other places, and so do filter weights, which may change the last bit of a
// half, or let a dark brick take a few millionths of the light of the one beside it.
inline bool sameInHalves(const glm::vec3& a, const glm::vec3& b) {
    return glm::all(glm::lessThanEqual(glm::abs(a - b), b / 1024.0F + 4e-6F));
}

inline void expectSameInHalves(const Image& picture, const Image& expected) {
    ASSERT_EQ(picture.pixels.size(), expected.pixels.size());
    for (std::size_t i = 0; i < expected.pixels.size(); ++i)
        ASSERT_TRUE(sameInHalves(picture.pixels[i], expected.pixels[i]))
            << "pixel " << i << ": " << glm::to_string(picture.pixels[i]) << ", expected "
            << glm::to_string(expected.pixels[i]);
}

}  // namespace vct::test
