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

// Headings of options in --help.
constexpr const char* lightGroup = "Light";
constexpr const char* voxelGroup = "Voxels";
constexpr const char* driverGroup = "Driver";
constexpr const char* measuringGroup = "Measuring and testing";
// Description of --preset.
constexpr const char* presetHelp =
    "Set of settings: mobile (made for phones, the fastest), quality (finer voxels and more rays) or thesis "
    "(the pipeline of the thesis)";

// Checks of options whose value is a number. They return what is wrong with the text; empty if it is valid.
// They are needed because CLI11 accepts NaN, infinity and numbers that no float holds.
std::string finite(const std::string& text);
std::string notEmpty(const std::string& text);
std::string positive(const std::string& text);  // finite and above 0

// Reads shaders from the folder in the environment variable VCT_SHADER_DIR, otherwise from the source tree
// that built the program.
gl::ReadShader shaders();

struct BackendOption {
    Backend backend = Backend::egl;
    int device = -1;  // -1: the driver's choice

    void addTo(CLI::App& command);
    // Throws vct::Error if the driver lacks something that the renderer requires.
    Context open() const;
};

// The scene's file, for commands that load one.
struct SceneFileOption {
    std::string path;
    bool allowOutside = false;
    double scale = 1.0;

    CLI::Option* addFileTo(CLI::App& command);  // returns the option of the path
    // Prints progress if loading takes long. `animation`: see GltfOptions.
    Scene load(const std::string& animation = "") const;
};

// A scene with its camera, sun, picture size and voxels.
struct SceneOptions : SceneFileOption {
    std::string camera, light;
    glm::ivec2 size{400, 400};
    bool hasSize = false;             // --size was given
    std::optional<std::string> grid;  // a number or "auto"
    std::optional<double> voxelSize;  // metres
    std::optional<int> cascades;
    BackendOption backend;

    // Both return the option of the scene's path.
    CLI::Option* addTo(CLI::App& command);
    CLI::Option* addSceneTo(CLI::App& command);
    // Without --size, gives the picture the shape that the camera is made for, if it is made for one.
    void fitSize(const Scene& loaded);
    // Chooses the camera, and prints a note if vct had to frame the scene itself.
    Camera cameraOf(const Scene& loaded) const;
    // The settings of the preset, with the picture size and a grid that is given as a number.
    Settings settings(const std::string& preset) const;
    // Sets the grid if it depends on the scene (--grid auto, --voxel-size). Prints the voxel size and the
    // reason for the choice, or a warning if the voxels are too coarse.
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
