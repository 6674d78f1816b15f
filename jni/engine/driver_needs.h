// Requirements of settings on a driver, beyond those of every output (gl/requirements.h).
#pragma once

#include <cstddef>
#include <vector>

#include "engine/settings.h"
#include "gl/capabilities.h"

namespace vct {

// Met or not.
std::vector<gl::Requirement> needsOf(const Settings& settings, const gl::Capabilities& capabilities);

// Throws one vct::Error that names every one that is not met.
void requireNeeds(const Settings& settings, const gl::Capabilities& capabilities);

// Memory of the voxels' textures and lists at a grid, without sums and light, which follow from the scene.
std::size_t voxelBytes(const Settings& settings, int grid);

// Returns those of allGrids() that the driver can do, and for which `bytes` are enough.
std::vector<int> possibleGrids(const Settings& settings, const gl::Capabilities& capabilities,
                               std::size_t bytes);

}  // namespace vct
