// vct info: the driver, and whether it has all that the pipeline needs; or the size and the features of a
// scene.
#include <cstdio>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "core/error.h"
#include "core/list_text.h"
#include "core/number_text.h"
#include "core/one_line.h"
#include "engine/grid_choice.h"
#include "engine/voxelization.h"
#include "gl/capabilities.h"
#include "scene/camera.h"
#include "scene/gltf.h"
#include "scene/gltf_names.h"
#include "scene/light_choice.h"
#include "scene/scene_features.h"

namespace vct::cli {
namespace {

struct InfoOptions {
    SceneOptions scene;
    bool listDevices = false, printCamera = false;
    std::string preset = defaultPreset;
};

constexpr const char* infoFooter =
    "Without a scene it checks the driver. With a scene it prints the scene's size, its voxels, its features "
    "(a frame "
    "has passes, programs and memory only for these), its cameras, lights, animations and variants, and what "
    "of "
    "it is not drawn.\n"
    "Exit code: 0 if the driver has everything that is required, 1 if something is missing or no OpenGL "
    "context can be created.\n"
    "Examples:\n"
    "  vct info                     checks the default driver\n"
    "  vct info --list-devices      lists the indices for --device\n"
    "  vct info --backend zink      checks OpenGL over Vulkan (lavapipe if there is no GPU)\n"
    "  vct info assets/courtyard.glb --grid auto\n"
    "                               prints the scene's size, voxels and features\n"
    "  vct info my.glb --print-camera --size 640x360\n"
    "                               prints the camera that a picture of this size uses";

void printDevices() {
    const std::vector<std::string> devices = eglDevices();
    if (devices.empty()) std::puts("EGL cannot enumerate devices here.");
    for (size_t i = 0; i < devices.size(); ++i)
        std::printf("%zu  %s\n", i, devices[i].c_str());
}

bool printCapabilities(const InfoOptions& options) {
    const BackendOption& backend = options.scene.backend;
    const Context context = openContext(backend.backend, backend.device);
    const gl::Capabilities& capabilities = context.capabilities;
    std::printf("back end:  %s, %s\n%s", backendName(backend.backend),
                context.platform->description().c_str(), gl::describe(capabilities).c_str());
    // In containers the driver's library often has no access to the GPU, so Mesa's software driver runs.
    if (capabilities.softwareDriver && backend.device < 0 && eglDevices().size() > 1)
        std::puts(
            "This is a software driver. EGL lists other devices: `vct info --list-devices` shows whether one "
            "of them is a GPU, and --device INDEX uses it.");
    for (const gl::Requirement& row : capabilities.requirements) {
        if (row.required && !row.met) return false;
    }
    return true;
}

std::string cameraText(const Camera& camera) {
    return "\"" + oneLine(camera.name) + "\" (" + numberText(glm::degrees(camera.verticalFovRad)) +
           " degrees" +
           (camera.aspectRatio ? ", made for " + numberText(*camera.aspectRatio) + " times as wide as high"
                               : "") +
           ")";
}

std::string lightText(const PunctualLight& light) {
    using Type = PunctualLight::Type;
    const std::string strength = numberText(light.intensity);
    return "\"" + oneLine(light.name) + "\" (" +
           (light.type == Type::directional ? "directional, " + strength + " lx"
            : light.type == Type::point     ? "point, " + strength + " cd"
                                            : "spot, " + strength + " cd") +
           ")";
}

// Prints what the file has besides surfaces, and what of it is not drawn.
void printContents(const SceneFileOption& file, const Scene& scene) {
    std::vector<std::string> cameras, lights;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i)
        cameras.push_back(std::to_string(i) + " " + cameraText(scene.cameras[i]));
    for (const DirectionalLight& sun : scene.lights)
        lights.push_back("the sun (" + numberText(sun.intensity) + " lx)");
    for (const PunctualLight& light : scene.punctualLights)
        lights.push_back(lightText(light));
    const GltfNames names = namesOfGltf(file.path, readFileFromDisk, {.allowOutside = file.allowOutside});
    const std::pair<const char*, const std::vector<std::string>*> rows[] = {
        {"cameras:   ", &cameras},
        {"lights:    ", &lights},
        {"animations:", &names.animations},
        {"variants:  ", &names.variants}};
    for (const auto& [title, items] : rows)
        std::printf("%s %s\n", title, items->empty() ? "none" : listText(*items).c_str());
    if (!names.variants.empty())
        std::puts(
            "not drawn: variants of materials; the materials are those that the file has without a variant");
    for (const std::string& warning : scene.warnings)
        std::printf("not drawn: %s\n", warning.c_str());
}

// Prints the size of the scene, the features that passes are built for, and the volume around it.
void printScene(const InfoOptions& options) {
    Settings settings = options.scene.settings(options.preset);
    validate(settings);
    const Scene scene = options.scene.load();
    const Context context = options.scene.backend.open();
    options.scene.fitGrid(settings, scene, context.capabilities);
    const SceneFeatures features = featuresOf(scene);
    const glm::dvec3 extent = scene.boundsWorld.max - scene.boundsWorld.min;
    std::printf("%s: %zu triangles, %zu instances, %d materials, %.3g x %.3g x %.3g m\n", scene.path.c_str(),
                scene.triangleCount(), scene.instances.size(), features.materials, extent.x, extent.y,
                extent.z);
    std::printf("volume:    %s\n", gridText(scene.boundsWorld, settings.grid, settings.cascades).c_str());
    const std::pair<const char*, bool> rows[] = {
        {"textures", features.has(featureBaseColorTexture)},
        {"alpha masks", features.has(featureAlphaMask)},
        {"vertex colours", features.has(featureVertexColors)},
        {"normal maps", features.has(featureNormalMap)},
        {"gloss", features.glossy},
        {"unlit materials", features.has(featureUnlit)},
        {"emission", features.has(featureEmissive)},
        {"punctual lights", !scene.punctualLights.empty()},
        {"moving objects", features.movingObjects},
        {"skins or morph targets", features.deforms},
        {"moving lights", features.movingLight},
    };
    std::string found;
    for (const auto& [name, occurs] : rows)
        if (occurs) found += (found.empty() ? "" : ", ") + std::string(name);
    std::printf("features:  %s\n", found.empty() ? "none besides triangles of one colour" : found.c_str());
    printContents(options.scene, scene);
    if (const std::string note = voxelizationNote(settings.voxels, context.capabilities); !note.empty())
        say(note);
}

// Prints the camera as JSON, so that other tools need not know how a camera is chosen. Needs no driver.
void printCamera(InfoOptions& options) {
    const Scene scene = options.scene.load();
    options.scene.fitSize(scene);
    const Camera camera = options.scene.cameraOf(scene);
    const auto three = [&](int column) {
        const glm::dvec4& v = camera.worldFromCamera[column];
        return nlohmann::ordered_json{v.x, v.y, v.z};
    };
    const nlohmann::ordered_json json{{"option", cameraOption(camera, scene.boundsWorld)},
                                      {"name", camera.name},
                                      {"eye_world", three(3)},
                                      {"right_up_back", {three(0), three(1), three(2)}},
                                      {"vertical_fov_rad", camera.verticalFovRad},
                                      {"lights_itself", isLitByEmitters(scene)}};
    std::puts(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
}

}  // namespace

void addInfo(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand("info",
                                           "Show the GL driver and whether it has what the pipeline needs, "
                                           "or the size and the features of a scene");
    const auto options = std::make_shared<InfoOptions>();
    command->add_flag("--list-devices", options->listDevices,
                      "List the EGL devices and their indices, then exit");
    command->add_option("--preset", options->preset, "Chooses the grid of a scene: " + presetList())
        ->capture_default_str();
    CLI::Option* scene = options->scene.addTo(*command);
    command->add_flag("--print-camera", options->printCamera,
                      "Print, as JSON, the camera that --camera and --size result in, and the --camera text "
                      "that reproduces it, then exit");
    for (const char* sceneOption :
         {"--preset", "--grid", "--voxel-size", "--size", "--camera", "--light", "--print-camera"})
        command->get_option(sceneOption)->needs(scene);
    command->footer(infoFooter);
    command->callback([options, command, &exitCode] {
        const auto note = [&](std::initializer_list<const char*> names, const char* reason) {
            for (const char* name : names)
                if (command->count(name) > 0) say(std::string("note: ") + name + " has no effect: " + reason);
        };
        note({"--light"}, "vct info shows no light");
        if (options->printCamera)
            note({"--grid", "--voxel-size", "--preset"}, "the camera does not depend on voxels");
        else
            note({"--camera", "--size"}, "it needs --print-camera");
        if (options->listDevices)
            printDevices();
        else if (options->printCamera)
            printCamera(*options);
        else if (!options->scene.path.empty())
            printScene(*options);
        else if (!printCapabilities(*options))
            exitCode = 1;
    });
}

}  // namespace vct::cli
