// A preset for each kind of voxels, as a parameter of tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "engine/settings.h"

namespace vct::test {

// A preset at a size at which a test can draw many frames.
inline Settings smallPreset(const std::string& preset) {
    Settings settings = presetSettings(preset);
    settings.grid = 64;
    settings.size = glm::ivec2(48);
    settings.shadowMapSize = 128;
    settings.gather.refinedDirections = 0;  // tests of the refinement ask for it
    return settings;
}

inline Settings mobileSettings() {
    return smallPreset("mobile");
}

inline auto everyVoxelKind() {
    return testing::Values("thesis", "mobile");
}

inline std::string nameOfPreset(const testing::TestParamInfo<const char*>& test) {
    return test.param;
}

}  // namespace vct::test
