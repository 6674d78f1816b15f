// vct bench: measures the thesis's tables 5.2 to 5.5 or compares presets, in the same way as the app.
#include <cstdio>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "cli/sky_option.h"
#include "lab/bench_run.h"
#include "lab/options.h"
#include "scene/camera.h"
#include "scene/gltf.h"

namespace vct::cli {

namespace {

struct BenchOptions {
    SceneOptions scene;
    BenchRequest request;
    SkyOption sky;
    std::string out, json;
};

void bench(BenchOptions& options) {
    BenchRequest& request = options.request;
    const SceneOptions& given = options.scene;
    request.scene = given.path;
    request.size = given.size;
    request.camera = given.camera;
    request.light = given.light;
    for (const std::string& preset : request.presets)
        validate(given.settings(preset));
    std::optional<OutputFolder> out;
    if (!options.out.empty()) {
        out.emplace(options.out);
        for (const Output mode : allModes())
            requireNoFolder(out->file(std::string(outputName(mode)) + ".png"));
    }
    if (!options.json.empty()) requireWritableFile(options.json);

    Scene loaded = given.load();
    const Camera camera = cameraFromText(given.camera, loaded, aspectOf(given.size));
    options.sky.addRoomLight(loaded, camera, given.light);
    const auto scene = std::make_shared<const Scene>(std::move(loaded));
    DirectionalLight light = lightFromText(given.light, *scene);
    Settings sky;
    options.sky.applyTo(sky);
    // A measurement of a file with a sun is of the sun alone, as in the thesis.
    if (scene->lights.empty() && given.light.empty())
        options.sky.lightScene(*scene, camera, aspectOf(given.size), given.light, light, sky);
    const Context context = given.backend.open();
    if (given.grid || given.voxelSize || given.cascades) {
        Settings settings = given.settings(request.presets.front());
        given.fitGrid(settings, *scene, context.capabilities);
        request.grid = settings.grid;
        request.cascades = settings.cascades;
    }
    BenchRun run({request,
                  scene,
                  light,
                  sky,
                  context.capabilities,
                  shaders(),
                  backendName(given.backend.backend),
                  {},
                  say},
                 options.out);
    while (run.advance()) {
    }
    if (!options.json.empty()) writeJson(options.json, run.report().json);
    if (out) out->keep();
    std::fputs(run.report().text.c_str(), stdout);
}

}  // namespace

void addBench(CLI::App& app, int&) {
    CLI::App* command =
        app.add_subcommand("bench", "Measure the thesis's tables 5.2 to 5.5, or compare presets");
    auto options = std::make_shared<BenchOptions>();
    BenchRequest& request = options->request;
    command->footer(
        "With the preset thesis alone, at its grid of 256, it prints the tables of the thesis with the rows "
        "measured here above those of the thesis. It measures 5 configurations, each --repeat times.\n"
        "With any other choice it prints a row of step times for each preset, and the ratios of the first "
        "preset's times to those of the others.\n"
        "Every frame rebuilds shadow map, voxels and light, as if everything in the scene had changed.\n"
        "Do not use the machine for anything else meanwhile. docs/timings.md explains the method and the "
        "files.\n"
        "Examples:\n"
        "  vct bench assets/cornell.glb\n"
        "  vct bench assets/cornell.glb --preset thesis,mobile,quality --json out/presets.json");
    command->add_option("--out", options->out,
                        "Folder for the tables (JSON and text) and for the timings and pictures of the first "
                        "run; created if missing");
    command->add_option("--json", options->json, "File for the tables and every measurement, as JSON");
    command->add_option("--repeat", request.repeat, "Runs of each configuration, each with a new renderer")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
    command
        ->add_option("--preset", request.presets,
                     std::string(presetHelp) +
                         "; several separated by commas. Only thesis alone gives the tables of the thesis")
        ->delimiter(',')
        ->capture_default_str();
    options->scene.addTo(*command)->required();
    options->sky.addTo(*command);
    command
        ->add_option("--shadow-map", request.shadowMap,
                     "Size of the shadow map, the same for all presets: texels per side, 16 to 8192")
        ->capture_default_str();
    command->callback([options] { bench(*options); });
}

}  // namespace vct::cli
