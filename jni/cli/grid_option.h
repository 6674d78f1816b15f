// --grid and --voxel-size, of the commands that take them.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "engine/settings.h"
#include "scene/scene.h"

namespace vct::cli {

struct GridOption {
    std::optional<std::string> grid;  // a number or "auto"
    std::optional<double> voxelSize;  // metres

    bool given() const { return grid || voxelSize; }
    void addTo(CLI::App& command);
    // Sets a grid that is given as a number; the preset's stays where it follows from the scene.
    void applyNumber(Settings& settings) const;
    // Sets one that follows from the scene. Prints how large the voxels are, and why. `texturesInMainMemory`:
    // so how much memory there is can be asked.
    void applyScene(Settings& settings, const Scene& scene, bool texturesInMainMemory) const;
};

}  // namespace vct::cli
