// Chooses the grid for a scene if the user does not give one.
#pragma once

#include <cstddef>
#include <string>

#include "engine/settings.h"
#include "gl/capabilities.h"
#include "scene/scene.h"

namespace vct {

struct GridChoice {
    int grid = 0;
    std::string reason;  // for the user: "grid 128: voxels of 6.5 cm; ..."
    int cascades = 1;    // Settings::cascades
};

// For the user: "grid 64: voxels of 3.39 cm", or "grid 64, 5 cascades: voxels of 13.4 cm around the camera to
// 2.14 m far from it".
std::string gridText(const Bounds& boundsWorld, int grid, int cascades = 1);
// A warning for the user that names parts of the scene that are narrower than a voxel of Settings::grid, and
// the remedy. Empty if there are none.
std::string coarseGridWarning(const Scene& scene, const Settings& settings);

// The fewest cascades of Settings::grid whose finest voxels are not larger than this, or as many as there may
// be. 1 for packed voxels.
int cascadesForVoxelSize(const Bounds& boundsWorld, const Settings& settings, double metres);

// The coarsest grid whose voxels are not larger than this. If those of the finest grid of Settings::gridRange
// are, and voxels are directional, the fewest cascades whose finest voxels are not larger. Throws vct::Error
// if there is no such choice.
GridChoice chooseForVoxelSize(const Bounds& boundsWorld, const Settings& settings, double metres);

// The coarsest grid of Settings::gridRange with two voxels across the narrowest parts of the scene. If the
// driver does not support it, or it needs more than `bytes`, a coarser one. If the driver supports none, the
// coarsest one, for which the constructor of Renderer reports what the driver lacks. If directional voxels of
// the finest grid are larger than the narrowest parts need, cascades of the coarsest grid, as many as are
// needed and allowed, because a fine cube of a whole large scene costs too much. The narrowest parts
// make up 2 % of the surface, because otherwise a single screw could decide.
//
// With two voxels across, a part fills at least one voxel alone. The width of a part depends on the kind of
// voxels (scene/thickness.h measures the sides, and counts no sheets):
// - Voxels::directional: the second-shortest side. A wall may be thinner than a voxel, because voxels keep
//   surfaces of opposite directions apart. A part that is narrow in two directions, such as a slat, may not.
// - Voxels::packed: the shortest side, because a voxel has one colour for both sides of a wall and leaks it
//   into both rooms.
GridChoice chooseGrid(const Scene& scene, const Settings& settings, const gl::Capabilities& capabilities,
                      std::size_t bytes);

}  // namespace vct
