// vct bench: the thesis's tables 5.2 to 5.5 measured here, or presets side by side, as the app measures them.
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
    if (!options.out.empty()) out.emplace(options.out);
    if (!options.json.empty()) requireWritableFile(options.json);

    const auto scene = std::make_shared<const Scene>(given.load());
    DirectionalLight light = lightFromText(given.light, *scene);
    Settings sky;
    options.sky.applyTo(sky);
    options.sky.lightScene(*scene, given.light, light, sky);
    const Context context = given.backend.open();
    if (given.grid || given.voxelSize) {
        Settings settings = given.settings(request.presets.front());
        given.fitGrid(settings, *scene, context.capabilities);
        request.grid = settings.grid;
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
        app.add_subcommand("bench", "Measure the thesis's tables 5.2 to 5.5, or presets side by side");
    auto options = std::make_shared<BenchOptions>();
    BenchRequest& request = options->request;
    command->footer(
        "Prints the thesis's tables, each with its rows beside those measured here, in 5 renderers for each "
        "--repeat.\n"
        "Of other or several presets it prints what each step takes, and how many times that of the first "
        "preset:\n"
        "  vct bench assets/cornell.glb --preset thesis,mobile,quality\n"
        "Every frame makes shadow maps, voxels and light anew. A sky is what cones see where they leave the "
        "scene, and "
        "the background: --environment FILE measures with a picture of it, --sky with a plain one.\n"
        "Use the machine for nothing else meanwhile. docs/timings.md says more.");
    command->add_option("--out", options->out,
                        "Folder for the tables as JSON and as text, and for the first run's timings and "
                        "pictures; made if missing");
    command->add_option("--json", options->json, "Write the tables and every measurement to FILE");
    command->add_option("--repeat", request.repeat, "Fresh renderers for each configuration")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
    command
        ->add_option(
            "--preset", request.presets,
            "Sets of settings, several with commas: " + presetList() + "; thesis alone gives the tables")
        ->delimiter(',')
        ->capture_default_str();
    options->scene.addTo(*command)->required();
    options->sky.addTo(*command);
    command->add_option("--shadow-map", request.shadowMap, "Texels along a side")->capture_default_str();
    command->callback([options] { bench(*options); });
}

}  // namespace vct::cli
