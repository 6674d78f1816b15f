#include "cli/grid_option.h"

#include <limits>
#include <sstream>

#include "cli/numbers.h"
#include "cli/progress.h"
#include "core/error.h"
#include "core/memory.h"
#include "engine/grid_choice.h"

namespace vct::cli {

namespace {
constexpr const char* automatic = "auto";
}

void GridOption::addTo(CLI::App& command) {
    CLI::Option* gridOption = command.add_option("--grid", grid,
                                                 "Voxels along a side: 64, 128, 256, 512, or auto, by the "
                                                 "scene's narrowest parts (default: the preset's)");
    command
        .add_option("--voxel-size", voxelSize,
                    "Largest voxel in metres: the smallest grid with such voxels around the scene")
        ->check(number("a length above 0, in metres", [](double v) { return v > 0.0; }))
        ->excludes(gridOption);
}

void GridOption::applyNumber(Settings& settings) const {
    if (!grid || *grid == automatic) return;
    std::istringstream text(*grid);
    if (!(text >> settings.grid) || !text.eof())
        throw Error("--grid '" + *grid + "' is not one of 64, 128, 256, 512, auto");
}

void GridOption::applyScene(Settings& settings, const Scene& scene, bool texturesInMainMemory) const {
    if (grid == automatic) {
        const std::size_t bytes =
            texturesInMainMemory ? availableMemory() : std::numeric_limits<std::size_t>::max();
        const GridChoice choice = chooseGrid(scene, settings, bytes);
        settings.grid = choice.grid;
        say(choice.reason);
        return;
    }
    if (voxelSize) settings.grid = gridForVoxelSize(scene.boundsWorld, *voxelSize);
    say(gridText(scene.boundsWorld, settings.grid));
    const std::string warning = coarseGridWarning(scene, settings);
    if (!warning.empty()) say(warning);
}

std::string GridOption::name(int presetGrid) const {
    if (voxelSize) return "voxels of a given size";
    if (grid == automatic) return "grid auto";
    return grid.value_or(std::to_string(presetGrid)) + "^3";
}

std::string GridOption::argument(int presetGrid) const {
    if (!voxelSize) return "--grid=" + grid.value_or(std::to_string(presetGrid));
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << "--voxel-size=" << *voxelSize;
    return text.str();
}

}  // namespace vct::cli
