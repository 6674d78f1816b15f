#include "cli/without_effect.h"

#include <algorithm>

#include "scene/light_choice.h"
#include "scene/scene_features.h"

namespace vct::cli {

std::vector<std::string> optionsWithoutEffect(const Run& run) {
    const auto shown = [&](auto reads) {
        return run.showsParts || std::any_of(run.modes.begin(), run.modes.end(),
                                             [&](Output mode) { return reads(vct::reads(mode)); });
    };
    const bool softShadow = shown([](const OutputReads& read) { return read.softShadow; });
    const bool shadowMap = shown([](const OutputReads& read) { return read.shadowMap(); });
    const bool voxels = shown([](const OutputReads& read) { return read.voxels; });
    const bool gathers =
        shown([](const OutputReads& read) { return read.ambientVisibility || read.indirectLight; });
    const bool hasSun = isOn(run.sun);
    const std::vector<PunctualLight>& others = run.scene.punctualLights;
    const bool hasSoftDirectional = run.settings.lightRadius > 0.0F &&
                                    std::any_of(others.begin(), others.end(), [](const PunctualLight& light) {
                                        return light.type == PunctualLight::Type::directional;
                                    });
    const bool isPacked = run.settings.voxels == Voxels::packed;
    const auto isGiven = [&](const char* option) { return run.given.count(option) != 0; };

    const char* const mode5 = "it needs the mode gi-cone-shadow";
    const char* const noSun = "the scene has no sun";
    const char* const noVoxels = "the modes phong and shadow-map read no voxels";
    const struct {
        const char* option;
        bool isUseless;
        const char* reason;
    } rows[] = {
        {"--light-frames", isPacked, "the preset thesis computes all of the light in each frame"},
        {"--light-frames", !gathers, noVoxels},
        {"--cone-angle", !softShadow, mode5},
        {"--cone-angle", !hasSun && !hasSoftDirectional, noSun},
        {"--light-radius", !softShadow, mode5},
        {"--light-radius", others.empty(), "the scene has no lights besides the sun"},
        {"--shadow-map", !shadowMap, "the mode phong has no shadows"},
        {"--shadow-map", !hasSun, noSun},
        {"--emission", !run.hasEmitters, "no surface of the scene emits light"},
        {"--grid", !voxels, noVoxels},
        {"--voxel-size", !voxels, noVoxels},
        {"--active-voxels", !voxels, noVoxels},
        {"--revoxelize", !isGiven("--timings"), "it changes only the times that --timings measures"},
        {"--contact-sheet", run.modes.size() == 1, "a sheet needs several modes, such as --mode all"},
        {"--converged", isPacked, "the preset thesis computes all of the light in each frame"},
        {"--animation", !isGiven("--time") && !isGiven("--frames"),
         "the scene is shown at rest without --time or --frames"},
    };
    std::vector<std::string> sentences;
    std::set<std::string> said;
    for (const auto& row : rows)
        if (row.isUseless && isGiven(row.option) && said.insert(row.option).second)
            sentences.push_back(std::string(row.option) + " has no effect: " + row.reason);
    return sentences;
}

}  // namespace vct::cli
