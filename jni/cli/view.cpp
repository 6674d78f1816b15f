// vct view: shows a scene in a window to walk through.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/sky_option.h"
#include "core/error.h"
#include "lab/options.h"
#include "scene/gltf.h"
#include "scene/light_choice.h"
#ifdef VCT_HAS_GLFW
#include "app/log.h"
#include "core/number_text.h"
#include "desktop/window.h"
#include "image/tone_map.h"
#include "scene/camera.h"
#endif

namespace vct {

#ifdef VCT_HAS_GLFW
// Prints the viewer's messages.
void app::log(LogLevel level, const std::string& text) {
    if (level == LogLevel::detail) return;
    cli::say((level == LogLevel::error     ? "vct: error: "
              : level == LogLevel::warning ? "warning: "
                                           : "") +
             text);
}
#endif

namespace cli {
namespace {

struct ViewOptions {
    SceneOptions scene;
    SkyOption sky;
    std::string preset = defaultPreset, mode = "gi-cone-shadow", exposure = "auto";
    std::optional<float> coneAngleDeg;
    std::optional<double> timeS;
};

#ifdef VCT_HAS_GLFW
using app::FileChoice;

// Lists the scene and the other files in its folder that have one of these extensions.
std::vector<FileChoice> filesBeside(const ViewOptions& options, const std::vector<std::string>& extensions) {
    const std::string& path = options.scene.path;
    namespace fs = std::filesystem;
    std::vector<FileChoice> files;
    const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const std::string ending = entry.path().extension().string();
        if (!entry.is_regular_file(ignored) ||
            std::find(extensions.begin(), extensions.end(), ending) == extensions.end())
            continue;
        const bool same = entry.path().filename() == fs::path(path).filename();
        files.push_back({entry.path().filename().string(), same ? path : entry.path().string(), false,
                         options.scene.allowOutside && same, same ? options.scene.scale : 1.0,
                         !options.sky.given() && (!same || options.scene.light.empty()),
                         !options.sky.given()});
    }
    std::sort(files.begin(), files.end(),
              [](const FileChoice& a, const FileChoice& b) { return a.name < b.name; });
    return files;
}

// The shortest text that reads back as the same float.
std::string floatText(float value) {
    char text[32];
    for (int digits = 6; digits <= 9; ++digits) {
        std::snprintf(text, sizeof text, "%.*g", digits, double{value});
        if (std::strtof(text, nullptr) == value) break;
    }
    return text;
}

std::string threeText(const glm::vec3& v) {
    return floatText(v.x) + "," + floatText(v.y) + "," + floatText(v.z);
}

// The `vct render` command that renders the same picture.
std::string renderLine(const app::Viewer::Seen& seen, const app::Choices& choices,
                       const ViewOptions& options) {
    const Settings& settings = seen.settings;
    std::string line = "vct render '" + seen.path + "' --out out --samples 1 --preset " + choices.preset +
                       " --mode " + outputName(choices.mode) + " --grid " + std::to_string(settings.grid) +
                       (settings.cascades > 1 ? " --cascades " + std::to_string(settings.cascades) : "") +
                       " --size " + std::to_string(settings.size.x) + "x" + std::to_string(settings.size.y) +
                       " --cone-angle " + numberText(settings.shadowConeAngleDeg) + " --camera " +
                       seen.cameraOption;
    const DirectionalLight& light = seen.light;
    // A sun that the scene animates, or one that is off, comes from the scene again.
    if (light.node < 0 && isOn(light)) {
        line += " --light direction=" + threeText(-glm::vec3(light.directionToLight)) +
                ",color=" + threeText(light.color) + ",intensity=" + floatText(light.intensity);
    }
    if (settings.environment)
        line += " --environment '" +
                (!seen.skyPath.empty() ? seen.skyPath
                 : options.sky.given() ? options.sky.environment
                                       : app::pathBeside(seen.path, app::skyExtension)) +
                "'";
    else if (choices.sky != app::Sky::scene || settings.skyRadiance != glm::vec3(0.0F) || isOn(light))
        line += " --sky " + threeText(settings.skyRadiance);
    if (settings.background) line += " --background " + threeText(*settings.background);
    char time[32];
    std::snprintf(time, sizeof time, " --time %.9g", seen.timeS.value_or(0.0));
    if (seen.timeS) line += time;
    return line + " --exposure " + numberText(seen.exposure);
}

void save(const app::Viewer::Seen& seen, const app::Choices& choices, const ViewOptions& options) {
    std::string file;
    for (int n = 1; file.empty() || std::filesystem::exists(file); ++n)
        file = "vct-view-" + std::to_string(n) + ".png";
    std::printf("%s\n", renderLine(seen, choices, options).c_str());
    std::fflush(stdout);
    if (choices.lightsOff.any())
        say("note: the window has some emitters switched off; vct render has no option for single emitters "
            "and renders all of them");
    writePng(file, toneMapped(seen.radiance, ToneMap::neutral, seen.exposure));
    say("saved " + file);
}

// Returns false if the scene could not be loaded.
bool view(const ViewOptions& options) {
    const std::string& path = options.scene.path;
    desktop::WindowRequest request;
    app::Choices& choices = request.show.choices;
    app::choosePreset(choices, options.preset);
    choices.grid = options.scene.settings(options.preset).grid;
    choices.cascades = options.scene.cascades;
    const std::vector<Output> modes = parsed("--mode", modesFromText, options.mode);
    if (modes.size() != 1) throw Error("--mode " + options.mode + ": a window shows one mode; name one");
    choices.mode = modes.front();
    choices.resolution = 1;  // the window's full resolution
    choices.coneAngleDeg = options.coneAngleDeg.value_or(presetSettings(options.preset).shadowConeAngleDeg);
    choices.play = !options.timeS;
    request.show.timeS = options.timeS.value_or(0.0);
    request.show.scene = path;
    validate(app::settingsFor(choices, options.scene.size, 1.0));
    Settings sky;
    options.sky.applyTo(sky);
    // Checks the options before a window opens.
    const std::string& camera = options.scene.camera;
    if (camera.find('=') != std::string::npos) cameraFromText(camera, {});
    lightFromText(options.scene.light, {});
    readFileFromDisk(path);

    request.title = "vct: " + std::filesystem::path(path).filename().string();
    request.size = options.scene.size;
    app::ViewerHost& desktop = request.host;
    desktop.backend = "window";
    desktop.folder = "vct-view";
    desktop.shaders = shaders();
    desktop.testsDriverFirst = false;
    desktop.findScenes = [&options] { return filesBeside(options, {".glb", ".gltf"}); };
    desktop.findSkies = [&options] { return filesBeside(options, {app::skyExtension}); };
    desktop.openFile = [](const FileChoice&, const std::atomic<bool>& cancelled) -> ReadFile {
        return [&cancelled](const std::string& file) {
            if (cancelled) throw Error("loading was cancelled");
            return readFileFromDisk(file);
        };
    };
    desktop.keepScreenOn = [](bool) {};
    // The options for camera, light and grid apply only to the scene on the command line, not to the other
    // scenes of its folder.
    desktop.defaultsFor = [&options, sky](const Scene& scene, const app::LoadedSky& beside, double aspect) {
        const bool named = scene.path == options.scene.path;
        const std::string light = named ? options.scene.light : "";
        app::ViewDefaults look;
        if (named && !options.scene.camera.empty()) {
            look.camera = cameraFromText(options.scene.camera, scene, aspect);
            look.camera->aspectRatio = aspect;  // the camera was fitted to this aspect ratio
        }
        Settings settings = sky;
        look.light = lightFromText(light, scene);
        if (beside) {
            settings.environment = beside;
            if (scene.lights.empty() && scene.punctualLights.empty() && light.empty())
                look.light.intensity = 0.0F;
        } else {
            options.sky.lightScene(scene, look.camera.value_or(chooseCamera(scene, "", aspect)), aspect,
                                   light, look.light, settings);
        }
        look.skyRadiance = settings.skyRadiance;
        look.background = settings.background;
        look.environment = settings.environment;
        if (options.exposure != "auto") look.exposure = std::stof(options.exposure);
        if (named && (options.scene.grid || options.scene.voxelSize || options.scene.cascades)) {
            Settings fitted = options.scene.settings(options.preset);
            options.scene.fitGrid(fitted, scene, {});
            look.grid = fitted.grid;
            look.cascades = fitted.cascades;
        }
        return look;
    };
    request.save = [&options](const app::Viewer::Seen& seen, const app::Choices& now) {
        save(seen, now, options);
    };
    return desktop::runWindow(std::move(request));
}
#else
bool view(const ViewOptions&) {
    throw Error(
        "cannot open a window: this vct was built without GLFW; install libglfw3-dev (scripts/setup.sh does "
        "that) and build again");
}
#endif

}  // namespace

void addView(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand("view", "Show a glTF scene in a window and walk through it");
    const auto options = std::make_shared<ViewOptions>();
    options->scene.size = {800, 600};
    options->scene.addSceneTo(*command)->required();
    command
        ->add_option("--mode", options->mode,
                     "Mode to begin with: phong, shadow-map, ao, gi or gi-cone-shadow (`vct render --help` "
                     "explains them)")
        ->capture_default_str();
    command->add_option("--preset", options->preset, presetHelp)->capture_default_str();
    command
        ->add_option("--cone-angle", options->coneAngleDeg,
                     "Angular diameter of the sun in degrees, 0.1 to 170, for its soft shadow in mode 5 "
                     "(default: the preset's)")
        ->group(lightGroup);
    command
        ->add_option("--time", options->timeS,
                     "Show this moment of the scene's animation, in seconds (default: the animation plays)")
        ->check(CLI::Range(0.0, 1e6));
    command
        ->add_option("--exposure", options->exposure,
                     "Brightness of the picture: a factor, or auto, which chooses it by the scene's first "
                     "picture")
        ->check([](const std::string& text) { return text == "auto" ? std::string() : positive(text); })
        ->capture_default_str();
    options->sky.addTo(*command);
#ifdef VCT_HAS_GLFW
    command->footer(std::string(desktop::windowKeys) + "\nExample:\n  vct view assets/courtyard.glb");
#endif
    command->callback([options, &exitCode] {
        if (!view(*options)) exitCode = 1;
    });
}

}  // namespace cli
}  // namespace vct
