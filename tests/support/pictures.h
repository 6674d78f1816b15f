// Two pictures of one frame that two renderers drew.
#pragma once

#include <gtest/gtest.h>

#include "image/image.h"

namespace vct::test {

// Of the presets with directional voxels: where a renderer puts a brick of received light is up to the order
// in which its invocations ran. A place in that texture is rounded differently elsewhere, and so is a
// filter's weight, which may turn the last bit of a half.
inline void expectSameInHalves(const Image& picture, const Image& expected) {
    ASSERT_EQ(picture.pixels.size(), expected.pixels.size());
    for (std::size_t i = 0; i < expected.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = expected.pixels[i][c];
            ASSERT_NEAR(picture.pixels[i][c], value, value / 1024.0F) << "pixel " << i;
        }
}

}  // namespace vct::test
