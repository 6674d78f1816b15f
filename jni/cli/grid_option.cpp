#include "cli/grid_option.h"

#include <limits>

#include "cli/numbers.h"
#include "cli/progress.h"
#include "core/memory.h"
#include "engine/grid_choice.h"

namespace vct::cli {

namespace {
constexpr const char* automatic = "auto";
}

void GridOption::addTo(CLI::App& command) {
    CLI::Option* gridOption =
        command
            .add_option(
                "--grid", grid,
                "Voxels along a side, or auto, by the scene's narrowest parts (default: the preset's)")
            ->check(CLI::IsMember({"64", "128", "256", "512", automatic}));
    command
        .add_option("--voxel-size", voxelSize,
                    "Largest voxel in metres: the smallest grid with such voxels around the scene")
        ->check(positive)
        ->excludes(gridOption);
}

void GridOption::applyNumber(Settings& settings) const {
    if (grid && *grid != automatic) settings.grid = std::stoi(*grid);
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

}  // namespace vct::cli
