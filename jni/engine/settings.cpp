// The values of the presets, and the checks of settings.
#include "engine/settings.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "shared/layout.h"

namespace vct {

const std::vector<int>& allGrids() {
    static const std::vector<int> grids{64, 128, 256, 512};
    return grids;
}

const std::vector<std::string>& presetNames() {
    static const std::vector<std::string> names{"thesis", "mobile", "quality"};
    return names;
}

Settings presetSettings(const std::string& name) {
    // The defaults of all members are the thesis's values, the reference for everything that is measured.
    Settings settings;
    if (name == "thesis") return settings;
    settings.voxels = Voxels::directional;
    settings.shadowMapSize = 1024;
    settings.gather.refinedDirections = 1024;
    if (name == "mobile") {
        settings.grid = 64;
        settings.gridRange = {64, 128};
        return settings;
    }
    if (name == "quality") {
        settings.grid = 128;
        settings.gridRange = {128, 256};
        settings.gather.directions = 128;
        settings.gather.hitBits = 24;
        settings.gather.rays = 16;
        return settings;
    }
    throw Error("the preset '" + name + "' does not exist; the presets are: " + presetList());
}

GatherSettings Settings::gatherOfFrames() const {
    GatherSettings result = gather;
    if (revoxelize && cascades == 1) result.directions = std::min(result.directions, 16);
    // The hits of the faces of all cascades are most of their memory. Eight lie together.
    if (cascades > 1) result.directions = std::max(result.directions / 2, 8);
    return result;
}

std::string presetList() {
    std::string names;
    for (const std::string& preset : presetNames())
        names += (names.empty() ? "" : ", ") + preset;
    return names;
}

int maxCascadesFor(int grid) {
    return std::min(VCT_MAX_CASCADES, VCT_MAX_STACKED_VOXELS / grid);
}

void validate(const Settings& settings) {
    const auto require = [](bool ok, const std::string& message) {
        if (!ok) throw Error(message);
    };
    const int grid = settings.grid;
    require(std::count(allGrids().begin(), allGrids().end(), grid) > 0,
            "a grid of " + std::to_string(grid) + " voxels is not one of 64, 128, 256, 512");
    require(
        settings.size.x >= 1 && settings.size.y >= 1 && settings.size.x <= 8192 && settings.size.y <= 8192,
        "the picture's size must be between 1x1 and 8192x8192 pixels");
    require(settings.shadowMapSize >= 16 && settings.shadowMapSize <= 8192,
            "the shadow map must have between 16 and 8192 texels per side");
    require(settings.shadowConeAngleDeg >= 0.1F && settings.shadowConeAngleDeg <= 170.0F,
            "the cone angle (the sun's angular diameter) must be between 0.1 and 170 degrees");
    require(settings.lightRadius >= 0.0F && std::isfinite(settings.lightRadius),
            "the radius of lights must be 0 or above");
    require(settings.lightFrames >= 1 && settings.lightFrames <= 1000,
            "lightFrames must be between 1 and 1000");
    require(settings.aoDistance > 0.0F && settings.aoDistance <= 1.0F,
            "the distance of ambient occlusion must be above 0 and at most 1, in sides of the voxel volume");
    const int maxCascades = maxCascadesFor(grid);
    require(settings.cascades >= 1 && settings.cascades <= maxCascades,
            "the number of cascades at a grid of " + std::to_string(grid) + " must be between 1 and " +
                std::to_string(maxCascades));
    require(settings.voxels == Voxels::directional || settings.cascades == 1,
            "cascades do not work with the preset thesis; use another preset");
    require(!settings.environment || settings.skyRadiance == glm::vec3(0.0F),
            "the sky has a radiance and a picture; give either its radiance or a picture");
}

}  // namespace vct
