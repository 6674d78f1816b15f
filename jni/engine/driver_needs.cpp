#include "engine/driver_needs.h"

#include <algorithm>

#include "core/error.h"
#include "engine/directional/directional_voxelizer.h"
#include "engine/directional/directional_voxels.h"
#include "engine/voxelization.h"

namespace vct {

std::vector<gl::Requirement> needsOf(const Settings& settings, const gl::Capabilities& capabilities) {
    const gl::Limits& limits = capabilities.limits;
    const bool faces = settings.voxels == Voxels::directional;
    const std::string cubed = std::to_string(settings.grid) + "^3";
    std::vector<gl::Requirement> needs;
    const auto atLeast = [&](const char* name, int found, int needed, const std::string& neededBy) {
        needs.push_back({std::string(name) + " >= " + std::to_string(needed), std::to_string(found), neededBy,
                         true, found >= needed});
    };
    // Cascades follow each other along z.
    atLeast("GL_MAX_3D_TEXTURE_SIZE", limits.texture3d, settings.cascades * settings.grid,
            "needed for the voxels at " + cubed + "; use a coarser grid");
    atLeast("GL_MAX_FRAMEBUFFER_WIDTH", limits.framebufferWidth,
            faces ? FaceProjection::sideFor(settings.grid, pixelSamplesFor(capabilities)) : settings.grid,
            "needed for voxelization at " + cubed + "; use a coarser grid");
    atLeast("GL_MAX_TEXTURE_SIZE", limits.texture2d, std::max(settings.size.x, settings.size.y),
            "needed for the picture; use a smaller picture");
    // Cascades share the map as 2 x 2 tiles.
    const bool tiles = settings.cascades > 1;
    atLeast("GL_MAX_TEXTURE_SIZE", limits.texture2d, (tiles ? 2 : 1) * settings.shadowMapSize,
            tiles ? "needed for the four shadow maps of cascades; use a smaller shadow map"
                  : "needed for the shadow map; use a smaller shadow map");
    if (!faces) return needs;
    atLeast("GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS", limits.fragmentStorageBlocks, 3,
            "needed for directional voxels, whose fragments also add to the sums of faces; use the preset "
            "thesis");
    const std::string& derivatives = capabilities.faults.derivatives;
    needs.push_back({"derivatives in fragment shaders", derivatives.empty() ? "no fault known" : derivatives,
                     "needed for the coverage of directional voxels; use the preset thesis", true,
                     derivatives.empty()});
    return needs;
}

void requireNeeds(const Settings& settings, const gl::Capabilities& capabilities) {
    std::string missing;
    for (const gl::Requirement& need : needsOf(settings, capabilities))
        if (!need.met) missing += "\n  " + need.name + " (found: " + need.found + "): " + need.neededBy;
    if (!missing.empty())
        throw Error("the GL driver (" + capabilities.renderer + ", " + capabilities.version +
                    ") does not support these settings:" + missing);
}

bool isPossible(const Settings& settings, const gl::Capabilities& capabilities) {
    const std::vector<gl::Requirement> needs = needsOf(settings, capabilities);
    return std::all_of(needs.begin(), needs.end(), [](const gl::Requirement& need) { return need.met; });
}

std::size_t voxelBytes(const Settings& settings, int grid) {
    return settings.voxels == Voxels::packed
               ? VoxelPyramid::bytesFor(grid, settings.activeVoxelLimit)
               : DirectionalVoxels::bytesFor(grid, settings.cascades, settings.activeVoxelLimit);
}

std::vector<int> possibleGrids(const Settings& settings, const gl::Capabilities& capabilities,
                               std::size_t bytes) {
    std::vector<int> grids;
    for (const int grid : allGrids()) {
        Settings there = settings;
        there.grid = grid;
        if (voxelBytes(there, grid) <= bytes && isPossible(there, capabilities)) grids.push_back(grid);
    }
    return grids;
}

}  // namespace vct
