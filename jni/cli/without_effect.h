// Finds options of `vct render` that change nothing in the pictures of this run.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/output.h"
#include "engine/settings.h"
#include "scene/scene.h"

namespace vct::cli {

// The outputs of a run, and the options on its command line.
struct Run {
    std::set<std::string> given;  // "--light-frames"
    std::vector<Output> modes;
    bool showsParts = false;  // of the light, or debug views, which read everything
    const Settings& settings;
    const Scene& scene;
    const DirectionalLight& sun;
    bool hasEmitters = false;  // in the file, whatever --emission is
};

// Returns a sentence for each such option, with the reason.
std::vector<std::string> optionsWithoutEffect(const Run& run);

}  // namespace vct::cli
