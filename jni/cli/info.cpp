// vct info: shows the driver and what it lacks of what the renderer needs; for a scene, what each feature
// costs.
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/sky_option.h"
#include "core/error.h"
#include "gl/capabilities.h"
#include "lab/options.h"
#include "lab/scene_costs.h"
#include "scene/camera.h"
#include "scene/gltf.h"
#include "scene/light_choice.h"

namespace vct::cli {
namespace {

struct InfoOptions {
    SceneOptions scene;
    bool listDevices = false, printCamera = false;
    std::string preset = defaultPreset;
    std::string mode = "gi-cone-shadow";
    SkyOption sky;
    int timedFrames = 0;
};

constexpr const char* infoFooter =
    "Without a scene it checks the driver. With a scene it renders the scene with and without each of its "
    "features (emission, moving objects, further lights and so on) and prints what each adds to a frame: "
    "passes, programs, memory and, with --times, time.\n"
    "Exit code: 0 if the driver has everything that is required, 1 if something is missing or no OpenGL "
    "context can be created.\n"
    "Examples:\n"
    "  vct info                     checks the default driver\n"
    "  vct info --list-devices      lists the indices for --device\n"
    "  vct info --backend zink      checks OpenGL over Vulkan (lavapipe if there is no GPU)\n"
    "  vct info assets/courtyard.glb --grid auto\n"
    "                               prints what each feature of the scene adds to a frame\n"
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

// Renders the scene, and the scene without each of its features, and prints the costs.
void printScene(const InfoOptions& options) {
    FrameOptions frame;
    frame.settings = options.scene.settings(options.preset);
    frame.settings.revoxelize = true;  // so that every pass runs in every frame
    options.sky.applyTo(frame.settings);
    validate(frame.settings);
    const std::vector<Output> modes = parsed("--mode", modesFromText, options.mode);
    if (modes.size() != 1)
        throw Error("--mode " + options.mode + ": the costs are those of one mode; name one");
    frame.mode = modes.front();
    frame.timedFrames = options.timedFrames;
    const Scene scene = options.scene.load();
    frame.camera = options.scene.cameraOf(scene);
    frame.light = lightFromText(options.scene.light, scene);
    options.sky.lightScene(scene, options.scene.light, frame.light, frame.settings);
    const Context context = options.scene.backend.open();
    options.scene.fitGrid(frame.settings, scene, context.capabilities);
    if (const std::string note = voxelizationNote(frame.settings.voxels, context.capabilities); !note.empty())
        say(note);
    const Progress progress("rendering " + scene.path + " with and without each feature");
    const SceneCosts costs = sceneCosts(scene, frame, context.capabilities, shaders());
    const glm::dvec3 extent = scene.boundsWorld.max - scene.boundsWorld.min;
    std::printf(
        "%s: %zu triangles, %zu instances, %d materials, %.3g x %.3g x %.3g m\n"
        "preset %s, mode %s, %dx%d pixels, %d^3 voxels\n\n%s",
        scene.path.c_str(), scene.triangleCount(), scene.instances.size(), featuresOf(scene).materials,
        extent.x, extent.y, extent.z, options.preset.c_str(), outputName(frame.mode), frame.settings.size.x,
        frame.settings.size.y, frame.settings.grid, sceneCostsText(costs, options.timedFrames > 0).c_str());
}

// Prints the camera as JSON, so that other tools need not know how a camera is chosen. Needs no driver.
void printCamera(const InfoOptions& options) {
    const Scene scene = options.scene.load();
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
                                      {"lights_itself", chooseSky(scene) == glm::vec3(0.0F)}};
    std::puts(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
}

}  // namespace

void addInfo(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand(
        "info", "Show the OpenGL driver and what it lacks, or what each feature of a scene costs");
    const auto options = std::make_shared<InfoOptions>();
    command->add_flag("--list-devices", options->listDevices,
                      "List the EGL devices and their indices, then exit");
    command->add_option("--preset", options->preset, presetHelp)->capture_default_str();
    command->add_option("--mode", options->mode, "Mode to render the scene in, one of those of `vct render`")
        ->capture_default_str();
    command
        ->add_option(
            "--times", options->timedFrames,
            "Time so many frames with and as many without each feature, and print the difference of their "
            "medians (default: no times)")
        ->check(CLI::Range(1, 1000));
    CLI::Option* scene = options->scene.addTo(*command);
    command->add_flag("--print-camera", options->printCamera,
                      "Print, as JSON, the camera that --camera and --size result in, and the --camera text "
                      "that reproduces it, then exit");
    options->sky.addTo(*command);
    for (const char* sceneOption : {"--preset", "--mode", "--grid", "--voxel-size", "--size", "--camera",
                                    "--light", "--sky", "--environment", "--times", "--print-camera"})
        command->get_option(sceneOption)->needs(scene);
    command->footer(infoFooter);
    command->callback([options, &exitCode] {
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
