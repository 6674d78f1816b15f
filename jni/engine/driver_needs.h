// Checks that a driver can do what settings ask for, beyond what every renderer needs (gl/requirements.h).
#pragma once

#include <cstddef>
#include <vector>

#include "engine/settings.h"
#include "gl/capabilities.h"

namespace vct {

// All requirements of the settings, whether they are met or not.
std::vector<gl::Requirement> needsOf(const Settings& settings, const gl::Capabilities& capabilities);
// Throws vct::Error that names every requirement that is not met.
void requireNeeds(const Settings& settings, const gl::Capabilities& capabilities);

// True if the driver meets every requirement of the settings.
bool isPossible(const Settings& settings, const gl::Capabilities& capabilities);

// Bytes of the voxels' textures and lists at a grid. The sums and the face irradiance are not included,
// because their size depends on the scene.
std::size_t voxelBytes(const Settings& settings, int grid);
// The grids of allGrids() that the driver supports and that need at most `bytes` (voxelBytes()).
std::vector<int> possibleGrids(const Settings& settings, const gl::Capabilities& capabilities,
                               std::size_t bytes);

}  // namespace vct
