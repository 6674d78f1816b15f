// Options that several commands take.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "core/error.h"
#include "engine/settings.h"
#include "gl/shader_source.h"
#include "platform/platform.h"
#include "scene/scene.h"

namespace vct::cli {

// Checks of options whose value is a number. They return what is wrong, or nothing. CLI11 takes NaN and
// infinity for numbers, and knows no float's limits.
std::string finite(const std::string& text);
std::string positive(const std::string& text);  // and above 0

// Reads shaders of the folder VCT_SHADER_DIR from the environment, or of the source tree that built the
// program.
gl::ReadShader shaders();

struct BackendOption {
    Backend backend = Backend::egl;
    int device = -1;  // the driver's choice

    void addTo(CLI::App& command);
    // Throws vct::Error where the driver lacks what the pipeline requires.
    Context open() const;
};

// A glTF file, of the commands that load one.
struct SceneFileOption {
    std::string path;
    bool allowOutside = false;

    CLI::Option* addFileTo(CLI::App& command);  // returns the path's
    // Says that it is at it where that takes long. `animation` as GltfOptions has it.
    Scene load(const std::string& animation = "") const;
};

// A scene, how it is seen, and in which voxels.
struct SceneOptions : SceneFileOption {
    std::string camera, light;
    glm::ivec2 size{400, 400};
    std::optional<std::string> grid;  // a number or "auto"
    std::optional<double> voxelSize;  // metres
    BackendOption backend;

    CLI::Option* addTo(CLI::App& command);       // returns the scene's
    CLI::Option* addSceneTo(CLI::App& command);  // likewise
    // Says what is to be said of it.
    Camera cameraOf(const Scene& loaded) const;
    // The preset's, with the size and a grid that is given as a number.
    Settings settings(const std::string& preset) const;
    // Sets a grid that follows from the scene. Prints how large the voxels are, and why.
    void fitGrid(Settings& settings, const Scene& loaded, const gl::Capabilities& capabilities) const;
};

// Parses an option's value; errors begin with the option's name.
template <class Parse, class Value>
auto parsed(const char* option, Parse parse, const Value& value) {
    try {
        return parse(value);
    } catch (const Error& error) {
        throw Error(std::string(option) + ": " + error.what());
    }
}

}  // namespace vct::cli
