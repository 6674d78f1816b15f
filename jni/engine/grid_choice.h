// How many voxels a scene needs, where that is not said as a number.
#pragma once

#include <cstddef>
#include <string>

#include "engine/settings.h"
#include "gl/capabilities.h"
#include "scene/scene.h"

namespace vct {

struct GridChoice {
    int grid = 0;
    std::string reason;  // for people: "grid 128: voxels of 6.5 cm; ..."
};

// For people: "grid 64: voxels of 3.39 cm".
std::string gridText(const Bounds& boundsWorld, int grid);

// For people: what narrow parts of the scene are lost in Settings::grid, and the remedy; else empty.
std::string coarseGridWarning(const Scene& scene, const Settings& settings);

// The smallest grid whose voxels around the scene are not larger than this. Throws vct::Error where the
// finest grid's are.
int gridForVoxelSize(const Bounds& boundsWorld, double metres);

// The smallest grid within Settings::gridRange whose voxels are half as large as the narrowest parts of the
// scene, up to the finest that the driver can do and for which there are `bytes` of memory. Where it can do
// none, the coarsest of the range, of which Renderer says what the driver lacks. The narrowest parts: those
// that make up 2 % of the surface; below that, one screw would decide.
//
// Two voxels across, so that in one of them at least a part has its voxel to itself. Across which side
// follows from the kind of voxels (scene/parts.h measures the sides):
// - Voxels::directional keep apart what looks in opposite directions, so a wall may be thinner than a voxel.
//   What is narrow in two directions, a slat or a column, may not: the second side counts.
// - Voxels::packed hold one colour, opaque once touched, so both sides of a wall shine into both rooms: the
//   shortest side counts, but for sheets, which have none.
GridChoice chooseGrid(const Scene& scene, const Settings& settings, const gl::Capabilities& capabilities,
                      std::size_t bytes);

}  // namespace vct
