// The options --sky and --environment.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "engine/settings.h"
#include "scene/scene.h"

namespace vct::cli {

struct SkyOption {
    std::optional<std::string> radiance;  // "R,G,B"
    std::string environment;              // path of a picture

    bool given() const { return radiance || !environment.empty(); }
    void addTo(CLI::App& command);
    // Sets the sky that was given. Throws vct::Error if its text or its file is not valid.
    void applyTo(Settings& settings) const;
    // Adds a light to a closed room without a light, unless the user gave a light or a sky, and prints it.
    void addRoomLight(Scene& scene, const Camera& camera, const std::string& lightText) const;
    // Chooses the light of a scene that has none, if the user gave no light either (`lightText` is empty):
    // only the given sky, or only the scene's emitters, or else a sun and a sky of one colour, which it
    // prints.
    void lightScene(const Scene& scene, const std::string& lightText, DirectionalLight& light,
                    Settings& settings) const;
};

}  // namespace vct::cli
