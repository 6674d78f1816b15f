// The options --sky, --environment and --background, and the light of scenes that lack some.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "engine/settings.h"
#include "scene/scene.h"

namespace vct::cli {

struct SkyOption {
    std::optional<std::string> radiance;    // "R,G,B"
    std::optional<std::string> background;  // "R,G,B"
    std::string environment;                // path of a picture

    bool given() const { return radiance || !environment.empty(); }
    void addTo(CLI::App& command);
    // Sets the sky and the background that were given. Throws vct::Error if their text or file is not valid.
    void applyTo(Settings& settings) const;
    // Adds a light to a closed room without a light, unless the user gave a light or a sky, and prints it.
    void addRoomLight(Scene& scene, const Camera& camera, const std::string& lightText) const;
    // Chooses what the scene's file and the options leave open, and prints the choice with the options for
    // it:
    // - For a sun without a sky, of the file or of the user (`lightText`): a sky of one colour, with a
    // background
    //   that contrasts.
    // - For a scene without a light, if the user gave none either: only the given sky, or only the scene's
    //   emitters, or else a sun with such a sky and background.
    // - For a scene with point lights and no sun: no sky, with a dim background.
    void lightScene(const Scene& scene, const Camera& camera, double aspect, const std::string& lightText,
                    DirectionalLight& light, Settings& settings) const;
};

}  // namespace vct::cli
