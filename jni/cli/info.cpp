// vct info: what the driver is, and whether it has all that the pipeline needs; of a scene, what each
// of its features costs.
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
    "Exit code: 0 if everything that is required is there, 1 if something is missing or no context can be "
    "made.\n"
    "Examples:\n"
    "  vct info                     the default driver\n"
    "  vct info --list-devices      the indices that --device takes\n"
    "  vct info --backend zink      OpenGL over Vulkan (lavapipe where there is no GPU)\n"
    "  vct info assets/courtyard.glb --grid auto\n"
    "                               what each feature of the scene adds to a frame\n"
    "  vct info my.glb --print-camera --size 640x360\n"
    "                               where it is seen from";

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
    // A driver library without access to its GPU is a common surprise in containers.
    if (capabilities.softwareDriver && backend.device < 0 && eglDevices().size() > 1)
        std::puts("EGL lists more than one device; --list-devices shows whether one of them is a GPU.");
    for (const gl::Requirement& row : capabilities.requirements) {
        if (row.required && !row.met) return false;
    }
    return true;
}

// Renders the scene, and the scene without each of its features.
void printScene(const InfoOptions& options) {
    FrameOptions frame;
    frame.settings = options.scene.settings(options.preset);
    frame.settings.revoxelize = true;  // what every pass costs
    options.sky.applyTo(frame.settings);
    validate(frame.settings);
    const std::vector<Output> modes = parsed("--mode", modesFromText, options.mode);
    if (modes.size() != 1) throw Error("--mode " + options.mode + ": the costs are of one mode; name one");
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
    const Progress progress("rendering " + scene.path + " with and without each of its features");
    const SceneCosts costs = sceneCosts(scene, frame, context.capabilities, shaders());
    const glm::dvec3 extent = scene.boundsWorld.max - scene.boundsWorld.min;
    std::printf(
        "%s: %zu triangles, %zu instances, %d materials, %.3g x %.3g x %.3g m\n"
        "preset %s, mode %s, %dx%d pixels, %d^3 voxels\n\n%s",
        scene.path.c_str(), scene.triangleCount(), scene.instances.size(), featuresOf(scene).materials,
        extent.x, extent.y, extent.z, options.preset.c_str(), outputName(frame.mode), frame.settings.size.x,
        frame.settings.size.y, frame.settings.grid, sceneCostsText(costs, options.timedFrames > 0).c_str());
}

// For tools: they need not know how a view is chosen. Without a driver.
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
        "info",
        "Show the GL driver and whether it has what the pipeline needs, or what a scene's features cost");
    const auto options = std::make_shared<InfoOptions>();
    command->add_flag("--list-devices", options->listDevices,
                      "List the EGL devices with their indices, and stop");
    command->add_option("--preset", options->preset, "Of a scene's frame: " + presetList())
        ->capture_default_str();
    command->add_option("--mode", options->mode, "Of a scene's frame, as for render")->capture_default_str();
    command
        ->add_option(
            "--times", options->timedFrames,
            "Time so many frames with and without each feature, in turn; the difference of the medians")
        ->check(CLI::Range(1, 1000));
    CLI::Option* scene = options->scene.addTo(*command);
    command->add_flag("--print-camera", options->printCamera,
                      "Print as JSON the camera by which --camera and --size see the scene, with the option "
                      "that repeats it, and stop");
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
