#include "cli/options.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
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

std::string notEmpty(const std::string& text) {
    return text.empty() ? "the value is empty" : "";
}

std::string positive(const std::string& text) {
    return finite(text).empty() && std::stod(text) > 0.0 ? "" : "'" + text + "' is not a number above 0";
}

gl::ReadShader shaders() {
    const char* folder = std::getenv("VCT_SHADER_DIR");
    return gl::shadersFromFolder(folder != nullptr && *folder != '\0' ? folder : VCT_DEFAULT_SHADER_DIR);
}

namespace {
// A picture is at most so many times as wide as high, or as high as wide, unless --size says so.
constexpr double maxAspect = 8.0;
}  // namespace

namespace {
// Returns a note if half of a scene's parts are so large that its file is probably not in metres; otherwise
// "".
std::string unitNote(const Scene& scene) {
    constexpr double largeScene = 1000.0, largePart = 50.0;  // metres
    const glm::dvec3 size = scene.boundsWorld.max - scene.boundsWorld.min;
    if (std::max({size.x, size.y, size.z}) < largeScene) return "";
    std::vector<double> parts;
    for (const Instance& instance : scene.instances) {
        std::vector<glm::dvec3> points;
        for (const Vertex& vertex : scene.meshes[static_cast<std::size_t>(instance.mesh)].vertices)
            points.emplace_back(vertex.position);
        const Bounds bounds = boundsOf(points, instance.worldFromObject);
        parts.push_back(glm::length(bounds.max - bounds.min));
    }
    const auto middle = parts.begin() + static_cast<std::ptrdiff_t>(parts.size() / 2);
    std::nth_element(parts.begin(), middle, parts.end());
    if (*middle < largePart) return "";
    char text[240];
    std::snprintf(
        text, sizeof text,
        "note: the scene is %.4g x %.4g x %.4g m, and half of its parts are larger than %.2g m; if it was "
        "exported in millimetres, --scale 0.001 makes metres of them",
        size.x, size.y, size.z, *middle);
    return text;
}
}  // namespace

void BackendOption::addTo(CLI::App& command) {
    command
        .add_option_function<std::string>(
            "--backend", [this](const std::string& name) { backend = backendFromName(name); },
            "How to create the OpenGL context: egl, osmesa (desktop OpenGL in software) or zink (OpenGL over "
            "Vulkan)")
        ->default_str(backendName(backend))
        ->group(driverGroup);
    command
        .add_option("--device", device,
                    "Index of an EGL device, as listed by `vct info --list-devices` (default: the driver's "
                    "choice)")
        ->check(CLI::Range(0, 1000))
        ->group(driverGroup);
}

Context BackendOption::open() const {
    Context context = openContext(backend, device);
    context.capabilities.requireAll();
    return context;
}

CLI::Option* SceneFileOption::addFileTo(CLI::App& command) {
    CLI::Option* const option = command.add_option("scene", path, "glTF file of the scene, .gltf or .glb");
    command
        .add_flag("--allow-outside", allowOutside,
                  "Read buffers and images of the scene even if they lie outside of its folder (links are "
                  "resolved first). Use it only for scenes that you trust")
        ->needs(option);
    command
        .add_option("--scale", scale,
                    "Multiply all lengths of the scene's file, such as by 0.001 for one that was exported in "
                    "millimetres instead of metres")
        ->check(positive)
        ->capture_default_str()
        ->needs(option);
    return option;
}

Scene SceneFileOption::load(const std::string& animation) const {
    const Progress progress("loading " + path, Progress::Begin::afterTwoSeconds);
    Scene scene = loadGltf(path, readFileFromDisk, {animation, allowOutside, scale});
    const std::string note = unitNote(scene);
    if (!note.empty()) say(note);
    return scene;
}

CLI::Option* SceneOptions::addTo(CLI::App& command) {
    CLI::Option* const sceneOption = addSceneTo(command);
    backend.addTo(command);
    return sceneOption;
}

CLI::Option* SceneOptions::addSceneTo(CLI::App& command) {
    CLI::Option* sceneOption = addFileTo(command);
    CLI::Option* gridOption = command
                                  .add_option("--grid", grid,
                                              "Voxels per side of the volume around the scene, or auto, "
                                              "which chooses grid and cascades by the "
                                              "scene's narrowest parts (default: the preset's)")
                                  ->check(CLI::IsMember({"64", "128", "256", "512", "auto"}))
                                  ->group(voxelGroup);
    command
        .add_option(
            "--voxel-size", voxelSize,
            "Largest voxel size in metres around the camera; selects the smallest grid that satisfies it, "
            "or cascades if the scene is too large for one")
        ->check(positive)
        ->excludes(gridOption)
        ->group(voxelGroup);
    command
        .add_option(
            "--cascades", cascades,
            "Nested cubes of voxels around the camera, each half as wide as the next (default: 1, the "
            "volume around the scene, or as many as --voxel-size needs)")
        ->check(CLI::Range(1, VCT_MAX_CASCADES))
        ->excludes("--voxel-size")
        ->group(voxelGroup);
    command
        .add_option_function<std::string>(
            "--size",
            [this](const std::string& text) {
                size = sizeFromText(text);
                hasSize = true;
            },
            "Size of the picture in pixels, WIDTHxHEIGHT. The default has as many pixels in the shape that a "
            "camera of the scene is made for")
        ->default_str(std::to_string(size.x) + "x" + std::to_string(size.y));
    command.add_option(
        "--camera", camera,
        "Camera as eye=X,Y,Z,target=X,Y,Z,fov=DEG,up=X,Y,Z, in metres and degrees, of which only eye is "
        "required (target: 0,0,0, fov: 45); or the name or index of one of the scene's cameras. Default: the "
        "scene's first camera; if it has none, a view of the whole scene or of the inside of a room, "
        "and vct prints the --camera that reproduces it");
    command
        .add_option("--light", light,
                    "Changes the sun, the scene's first directional light: "
                    "direction=X,Y,Z,color=R,G,B,intensity=LUX. The direction is the one in which the light "
                    "travels; each part may be left out")
        ->group(lightGroup);
    return sceneOption;
}

void SceneOptions::fitSize(const Scene& loaded) {
    if (hasSize || (loaded.cameras.empty() && camera.empty())) return;
    const Camera chosen = cameraFromText(camera, loaded);
    if (!chosen.aspectRatio) return;
    const double root = std::sqrt(std::clamp(*chosen.aspectRatio, 1.0 / maxAspect, maxAspect));
    const double side = std::sqrt(static_cast<double>(size.x) * size.y);
    // Encoders of videos take even sizes only.
    size = 2 * glm::ivec2(glm::round(0.5 * side * glm::dvec2(root, 1.0 / root)));
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
    if (cascades) result.cascades = *cascades;
    return result;
}

void SceneOptions::fitGrid(Settings& settings, const Scene& loaded,
                           const gl::Capabilities& capabilities) const {
    if (grid == "auto") {
        // OpenGL does not tell how much GPU memory is free, so only main memory limits the choice.
        const std::size_t bytes =
            capabilities.texturesInMainMemory ? availableMemory() : std::numeric_limits<std::size_t>::max();
        const GridChoice choice = chooseGrid(loaded, settings, capabilities, bytes);
        settings.grid = choice.grid;
        settings.cascades = choice.cascades;
        say(choice.reason);
        return;
    }
    if (voxelSize) {
        const GridChoice choice = parsed(
            "--voxel-size",
            [&](double metres) { return chooseForVoxelSize(loaded.boundsWorld, settings, metres); },
            *voxelSize);
        settings.grid = choice.grid;
        settings.cascades = choice.cascades;
    }
    say(gridText(loaded.boundsWorld, settings.grid, settings.cascades));
    const std::string warning = coarseGridWarning(loaded, settings);
    if (!warning.empty()) say(warning);
}

}  // namespace vct::cli
