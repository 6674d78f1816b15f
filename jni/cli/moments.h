// --time, --frames and --fps: which moments of an animated scene a command line asks for.
#pragma once

#include <CLI/CLI.hpp>
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
    void addTo(CLI::App& command);
};

// Seconds, one per frame. Empty: the scene at rest, one frame. Throws vct::Error where the scene has no
// animation and a moment of it was asked for.
std::vector<double> momentsOf(const MomentOptions& options, const Scene& scene);

// The end of the name of frame `index` of a sequence: "_0012".
std::string frameSuffix(std::size_t index);

}  // namespace vct::cli
