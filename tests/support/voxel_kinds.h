// The kinds of voxels and ways to make them, as parameters of a test suite.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "engine/settings.h"

namespace vct::test {

struct VoxelKind {
    const char* preset;
    Voxelization voxelization;
};

// Small, so that a test can draw many frames.
inline Settings settingsOf(const VoxelKind& kind) {
    Settings settings = presetSettings(kind.preset);
    settings.grid = 64;
    settings.size = glm::ivec2(48);
    settings.shadowMapSize = 128;
    settings.voxelization = kind.voxelization;
    return settings;
}

inline Settings mobileSettings() {
    return settingsOf({"mobile", Voxelization::sortedAxes});
}

inline auto everyVoxelKind() {
    return testing::Values(
        VoxelKind{"thesis", Voxelization::geometryShader}, VoxelKind{"thesis", Voxelization::sortedAxes},
        VoxelKind{"mobile", Voxelization::geometryShader}, VoxelKind{"mobile", Voxelization::sortedAxes});
}

// One of each preset; the other way to make them gives the same voxels (sorted_axes_test.cpp).
inline auto onePerPreset() {
    return testing::Values(VoxelKind{"thesis", Voxelization::geometryShader},
                           VoxelKind{"mobile", Voxelization::sortedAxes});
}

inline std::string nameOfKind(const testing::TestParamInfo<VoxelKind>& test) {
    return std::string(test.param.preset) +
           (test.param.voxelization == Voxelization::sortedAxes ? "SortedAxes" : "GeometryShader");
}

}  // namespace vct::test
