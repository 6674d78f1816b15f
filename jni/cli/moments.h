// Of an animated scene: which moments a command line asks for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace vct::cli {

struct MomentOptions {
    std::optional<double> timeS;
    std::optional<int> frames;
    std::optional<double> fps;

    bool asked() const { return timeS || frames || fps; }
};

// Throws vct::Error where the options do not go together or a number is out of range; needs no scene.
void validate(const MomentOptions& options);

// Seconds, one per frame. Empty: the scene at rest, one frame. Throws vct::Error where the scene has no
// animation and a moment of it was asked for.
std::vector<double> momentsOf(const MomentOptions& options, const Scene& scene);

// Of frame `index` of a sequence: "_0012".
std::string frameSuffix(std::size_t index);

}  // namespace vct::cli
