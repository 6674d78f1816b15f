#include "cli/options.h"

#include <cmath>
#include <cstdlib>
#include <limits>

#include "cli/progress.h"
#include "core/memory.h"
#include "engine/grid_choice.h"
#include "lab/options.h"
#include "scene/camera.h"
#include "scene/gltf.h"

namespace vct::cli {

std::string finite(const std::string& text) {
    float value = 0.0F;
    return CLI::detail::lexical_cast(text, value) && std::isfinite(value) ? ""
                                                                          : "'" + text + "' is not a number";
}

std::string positive(const std::string& text) {
    return finite(text).empty() && std::stod(text) > 0.0 ? "" : "'" + text + "' is not a number above 0";
}

gl::ReadShader shaders() {
    const char* folder = std::getenv("VCT_SHADER_DIR");
    return gl::shadersFromFolder(folder != nullptr && *folder != '\0' ? folder : VCT_DEFAULT_SHADER_DIR);
}

namespace {
void addSize(CLI::App& command, glm::ivec2& size) {
    command
        .add_option_function<std::string>(
            "--size", [&size](const std::string& text) { size = sizeFromText(text); },
            "Picture, WIDTHxHEIGHT")
        ->default_str(std::to_string(size.x) + "x" + std::to_string(size.y));
}
}  // namespace

void BackendOption::addTo(CLI::App& command) {
    command
        .add_option_function<std::string>(
            "--backend", [this](const std::string& name) { backend = backendFromName(name); },
            "Where the context comes from: egl, osmesa (software, desktop context), zink (over "
            "Vulkan)")
        ->default_str(backendName(backend));
    command
        .add_option("--device", device,
                    "EGL device by index (`vct info --list-devices`; default: the driver's choice)")
        ->check(CLI::Range(0, 1000));
}

Context BackendOption::open() const {
    Context context = openContext(backend, device);
    context.capabilities.requireAll();
    return context;
}

CLI::Option* SceneFileOption::addFileTo(CLI::App& command) {
    CLI::Option* const option = command.add_option("scene", path, "Scene, .gltf or .glb");
    command
        .add_flag("--allow-outside", allowOutside,
                  "Let the scene name buffers and images outside of its folder and those below it (links are "
                  "resolved first); only for files that you trust")
        ->needs(option);
    return option;
}

Scene SceneFileOption::load(const std::string& animation) const {
    const Progress progress("loading " + path, Progress::Begin::afterTwoSeconds);
    return loadGltf(path, readFileFromDisk, {animation, allowOutside});
}

CLI::Option* SceneOptions::addTo(CLI::App& command) {
    CLI::Option* const sceneOption = addSceneTo(command);
    backend.addTo(command);
    return sceneOption;
}

CLI::Option* SceneOptions::addSceneTo(CLI::App& command) {
    CLI::Option* sceneOption = addFileTo(command);
    CLI::Option* gridOption =
        command
            .add_option(
                "--grid", grid,
                "Voxels along a side, or auto, by the scene's narrowest parts (default: the preset's)")
            ->check(CLI::IsMember({"64", "128", "256", "512", "auto"}));
    command
        .add_option("--voxel-size", voxelSize,
                    "Largest voxel in metres: the smallest grid with such voxels around the scene")
        ->check(positive)
        ->excludes(gridOption);
    addSize(command, size);
    command.add_option(
        "--camera", camera,
        "eye=X,Y,Z,target=X,Y,Z,fov=DEG,up=X,Y,Z, all but eye may be left out; or a camera of the "
        "scene by name or index (default: its first; where it has none, a view of all of it, "
        "or of a closed room's inside, which is printed)");
    command.add_option(
        "--light", light,
        "direction=X,Y,Z (the way it travels),color=R,G,B,intensity=LUX over the scene's light; "
        "each part may be left out");
    return sceneOption;
}

Camera SceneOptions::cameraOf(const Scene& loaded) const {
    const double aspect = aspectOf(size);
    const Camera chosen = cameraFromText(camera, loaded, aspect);
    const std::string note = cameraNote(loaded, camera, chosen, aspect);
    if (!note.empty()) say(note);
    return chosen;
}

Settings SceneOptions::settings(const std::string& preset) const {
    Settings result = presetSettings(preset);
    result.size = size;
    if (grid && *grid != "auto") result.grid = std::stoi(*grid);
    return result;
}

void SceneOptions::fitGrid(Settings& settings, const Scene& loaded,
                           const gl::Capabilities& capabilities) const {
    if (grid == "auto") {
        // Only of main memory can be asked how much there is.
        const std::size_t bytes =
            capabilities.texturesInMainMemory ? availableMemory() : std::numeric_limits<std::size_t>::max();
        const GridChoice choice = chooseGrid(loaded, settings, capabilities, bytes);
        settings.grid = choice.grid;
        say(choice.reason);
        return;
    }
    if (voxelSize)
        settings.grid = parsed(
            "--voxel-size", [&](double metres) { return gridForVoxelSize(loaded.boundsWorld, metres); },
            *voxelSize);
    say(gridText(loaded.boundsWorld, settings.grid));
    const std::string warning = coarseGridWarning(loaded, settings);
    if (!warning.empty()) say(warning);
}

}  // namespace vct::cli
