#include "engine/grid_choice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "core/error.h"
#include "engine/driver_needs.h"
#include "engine/volume.h"
#include "scene/parts.h"
#include "scene/thickness.h"

namespace vct {

namespace {

constexpr double voxelsAcross = 2.0;
constexpr double shareOfSurface = 0.02;
// A part is a sheet if its shortest side is at most this share of the next one: 0 but for rounding.
constexpr double sheet = 1e-4;
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
    bool isPart = false;
    std::string name;  // the mesh's, of a part

    std::string text(Voxels voxels) const {
        return std::string("the narrowest 2 % of the surface are ") + (isPart ? "parts " : "") + "up to " +
               lengthText(across) + (voxels == Voxels::packed ? " thick" : " wide") +
               (name.empty() ? "" : " (\"" + name + "\")");
    }
};

// The width up to which parts make up shareOfSurface of the surface.
Narrow narrowestPart(const Scene& scene, Voxels voxels) {
    std::vector<Part> parts = connectedParts(scene);
    const auto across = [&](const Part& part) {
        const bool thin = voxels == Voxels::packed && part.sides[0] > sheet * part.sides[1];
        return part.sides[thin ? 0 : 1];
    };
    std::stable_sort(parts.begin(), parts.end(),
                     [&](const Part& a, const Part& b) { return across(a) < across(b); });
    double area = 0.0, total = 0.0;
    for (const Part& part : parts)
        total += part.area;
    for (const Part& part : parts) {
        area += part.area;
        if (area < shareOfSurface * total) continue;
        const Instance& instance = scene.instances[static_cast<std::size_t>(part.instance)];
        return {across(part), true, scene.meshes[static_cast<std::size_t>(instance.mesh)].name};
    }
    return {};
}

// Finds the width up to which parts, or places of larger ones, make up shareOfSurface of the surface.
// `longest`: a greater width does not matter.
Narrow narrowest(const Scene& scene, Voxels voxels, double longest) {
    Narrow part = narrowestPart(scene, voxels);
    std::vector<double> sizes;
    for (const LocalSize& size : localSizes(scene, measuredPoints, longest))
        sizes.push_back(voxels == Voxels::packed ? size.thickness : size.width);
    const auto rank = static_cast<std::ptrdiff_t>(shareOfSurface * static_cast<double>(sizes.size()));
    if (rank >= static_cast<std::ptrdiff_t>(sizes.size())) return part;
    std::nth_element(sizes.begin(), sizes.begin() + rank, sizes.end());
    const double local = sizes[static_cast<std::size_t>(rank)];
    return local < 0.99 * part.across ? Narrow{local, false, ""} : part;
}

}  // namespace

std::string gridText(const Bounds& boundsWorld, int grid) {
    return "grid " + std::to_string(grid) + ": voxels of " + lengthText(voxelSize(boundsWorld, grid));
}

std::string coarseGridWarning(const Scene& scene, const Settings& settings) {
    const double voxel = voxelSize(scene.boundsWorld, settings.grid);
    const Narrow narrow = narrowest(scene, settings.voxels, voxel);
    if (narrow.across <= 0.0 || narrow.across >= voxel) return {};
    return "warning: " + narrow.text(settings.voxels) +
           ", less than a voxel, so their light and shadow are wrong; use a finer grid, or remove distant "
           "objects from the scene";
}

int gridForVoxelSize(const Bounds& boundsWorld, double metres) {
    for (const int grid : allGrids())
        if (voxelSize(boundsWorld, grid) <= metres) return grid;
    const int finest = allGrids().back();
    throw Error("no grid has voxels of " + lengthText(metres) + ": the finest, " + std::to_string(finest) +
                "^3, gives this scene voxels of " + lengthText(voxelSize(boundsWorld, finest)) +
                "; ask for voxels of that size or larger, or render a part of the scene");
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
    if (limit.empty() && !enough(chosen)) limit = ", the finest of this preset";
    std::string reason = gridText(scene.boundsWorld, chosen) + limit;
    if (needed > 0.0)
        reason += needed < coarsest
                      ? "; " + narrow.text(settings.voxels) + ", which need voxels of " + lengthText(needed)
                      : std::string("; less than 2 % of the surface belongs to parts that are ") +
                            (settings.voxels == Voxels::packed ? "thinner" : "narrower") + " than two voxels";
    return {chosen, reason};
}

}  // namespace vct
