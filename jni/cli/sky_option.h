// --sky and --environment, of the commands that take them.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "engine/settings.h"
#include "scene/scene.h"

namespace vct::cli {

struct SkyOption {
    std::optional<std::string> radiance;  // R,G,B
    std::string environment;              // file of a picture

    bool given() const { return radiance || !environment.empty(); }
    void addTo(CLI::App& command);
    // Sets the sky that is given. Throws vct::Error where its text or its file is no sky.
    void applyTo(Settings& settings) const;
    // Where no light is given either (`lightText` is empty), what lights the scene: itself, the sky that is
    // given, or else a sun and a plain sky, which it says.
    void lightScene(const Scene& scene, const std::string& lightText, DirectionalLight& light,
                    Settings& settings) const;
};

}  // namespace vct::cli
