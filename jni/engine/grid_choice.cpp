#include "engine/grid_choice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "core/error.h"
#include "engine/driver_needs.h"
#include "engine/volume.h"
#include "scene/thickness.h"

namespace vct {

namespace {

constexpr double voxelsAcross = 2.0;
constexpr double shareOfSurface = 0.02;
// Points at which the thickness is measured. 2 % of them are 40.
constexpr std::size_t measuredPoints = 2000;

double voxelSize(const Bounds& boundsWorld, int grid) {
    return volumeAround(boundsWorld, grid).voxelSize();
}

std::string lengthText(double metres) {
    const struct {
        double metres;
        const char* name;
    } units[] = {{1000.0, "km"}, {1.0, "m"}, {0.01, "cm"}, {0.001, "mm"}};
    const auto* unit = units;
    while (unit != std::end(units) - 1 && metres < 0.9995 * unit->metres)
        ++unit;
    char text[32];
    std::snprintf(text, sizeof text, "%.3g %s", metres / unit->metres, unit->name);
    return text;
}

struct Narrow {
    double across = HUGE_VAL;  // metres
    std::string name;          // the mesh's

    std::string text(Voxels voxels) const {
        return "the narrowest 2 % of the surface are up to " + lengthText(across) +
               (voxels == Voxels::packed ? " thick" : " wide") + (name.empty() ? "" : " (\"" + name + "\")");
    }
};

// Finds the thickness or width up to which solids make up shareOfSurface of the surface. `longest`: a greater
// one does not matter.
Narrow narrowest(const Scene& scene, Voxels voxels, double longest) {
    const auto across = [&](const LocalSize& size) {
        return voxels == Voxels::packed ? size.thickness : size.width;
    };
    std::vector<LocalSize> sizes = localSizes(scene, measuredPoints, longest);
    const auto rank = static_cast<std::ptrdiff_t>(shareOfSurface * static_cast<double>(sizes.size()));
    if (rank >= static_cast<std::ptrdiff_t>(sizes.size())) return {};
    const auto found = sizes.begin() + rank;
    std::nth_element(sizes.begin(), found, sizes.end(),
                     [&](const LocalSize& a, const LocalSize& b) { return across(a) < across(b); });
    const Instance& instance = scene.instances[static_cast<std::size_t>(found->instance)];
    return {across(*found), scene.meshes[static_cast<std::size_t>(instance.mesh)].name};
}

}  // namespace

std::string gridText(const Bounds& boundsWorld, int grid, int cascades) {
    const double coarsest = voxelSize(boundsWorld, grid);
    if (cascades == 1) return "grid " + std::to_string(grid) + ": voxels of " + lengthText(coarsest);
    return "grid " + std::to_string(grid) + ", " + std::to_string(cascades) + " cascades: voxels of " +
           lengthText(std::ldexp(coarsest, 1 - cascades)) + " around the camera to " + lengthText(coarsest) +
           " far from it";
}

std::string coarseGridWarning(const Scene& scene, const Settings& settings) {
    const double voxel = std::ldexp(voxelSize(scene.boundsWorld, settings.grid), 1 - settings.cascades);
    const Narrow narrow = narrowest(scene, settings.voxels, voxel);
    if (narrow.across <= 0.0 || narrow.across >= voxel) return {};
    return "warning: " + narrow.text(settings.voxels) +
           ", less than a voxel, so their light and shadow are wrong; use a finer grid, cascades, or "
           "remove distant objects from the scene";
}

int cascadesForVoxelSize(const Bounds& boundsWorld, const Settings& settings, double metres) {
    const int most = settings.voxels == Voxels::directional ? maxCascadesFor(settings.grid) : 1;
    int cascades = 1;
    while (cascades < most && std::ldexp(voxelSize(boundsWorld, settings.grid), 1 - cascades) > metres)
        ++cascades;
    return cascades;
}

GridChoice chooseForVoxelSize(const Bounds& boundsWorld, const Settings& settings, double metres) {
    const bool directional = settings.voxels == Voxels::directional;
    for (const int grid : allGrids()) {
        if (directional && grid > settings.gridRange.finest) break;
        if (voxelSize(boundsWorld, grid) <= metres) return {grid, gridText(boundsWorld, grid), 1};
    }
    Settings nested = settings;
    nested.grid = directional ? settings.gridRange.coarsest : allGrids().back();
    const int grid = nested.grid, cascades = cascadesForVoxelSize(boundsWorld, nested, metres);
    const double finest = std::ldexp(voxelSize(boundsWorld, grid), 1 - cascades);
    if (finest > metres)
        throw Error("no grid has voxels of " + lengthText(metres) + ": the finest, " + std::to_string(grid) +
                    "^3" + (directional ? " with " + std::to_string(cascades) + " cascades" : "") +
                    ", gives this scene voxels of " + lengthText(finest) +
                    "; ask for voxels of that size or larger, or render a part of the scene");
    return {grid, gridText(boundsWorld, grid, cascades), cascades};
}

GridChoice chooseGrid(const Scene& scene, const Settings& settings, const gl::Capabilities& capabilities,
                      std::size_t bytes) {
    const std::vector<int> driverGrids =
        possibleGrids(settings, capabilities, std::numeric_limits<std::size_t>::max());
    const double coarsest = voxelSize(scene.boundsWorld, settings.gridRange.coarsest);
    const Narrow narrow = narrowest(scene, settings.voxels, voxelsAcross * coarsest);
    const double needed = narrow.across / voxelsAcross;
    const auto enough = [&](int grid) {
        return needed <= 0.0 || voxelSize(scene.boundsWorld, grid) <= needed;
    };
    int chosen = settings.gridRange.coarsest;
    std::string limit;
    for (const int grid : allGrids()) {
        if (enough(chosen)) break;
        if (grid <= chosen) continue;
        if (grid > settings.gridRange.finest) break;
        if (std::find(driverGrids.begin(), driverGrids.end(), grid) == driverGrids.end()) {
            limit = ", the finest that the driver allows";
            break;
        }
        if (voxelBytes(settings, grid) > bytes) {
            limit = ", the finest that memory allows";
            break;
        }
        chosen = grid;
    }
    int cascades = 1;
    if (settings.voxels == Voxels::directional && !enough(chosen)) {
        Settings nested = settings;
        nested.grid = settings.gridRange.coarsest;
        nested.cascades = cascadesForVoxelSize(scene.boundsWorld, nested, needed);
        if (isPossible(nested, capabilities) && voxelBytes(nested, nested.grid) <= bytes &&
            std::ldexp(voxelSize(scene.boundsWorld, nested.grid), 1 - nested.cascades) <
                voxelSize(scene.boundsWorld, chosen)) {
            chosen = nested.grid;
            cascades = nested.cascades;
            limit.clear();
        }
    }
    if (limit.empty() && !enough(chosen) && cascades == 1) limit = ", the finest of this preset";
    std::string reason = gridText(scene.boundsWorld, chosen, cascades) + limit;
    if (needed > 0.0)
        reason += needed < coarsest
                      ? "; " + narrow.text(settings.voxels) + ", which need voxels of " + lengthText(needed)
                      : std::string("; less than 2 % of the surface belongs to parts that are ") +
                            (settings.voxels == Voxels::packed ? "thinner" : "narrower") + " than two voxels";
    return {chosen, reason, cascades};
}

}  // namespace vct
