// vct bench: the thesis's tables 5.2 to 5.5 measured here, by its method (5.1.2): glFinish and the CPU's
// clock, frames to warm up, the average of 5 frames, all of it again in fresh processes.
#include <cstdio>
#include <fstream>
#include <optional>
#include <sstream>

#include "cli/child_process.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "core/error.h"
#include "core/files.h"
#include "measure/bench_plan.h"
#include "measure/options.h"
#include "measure/timings.h"
#include "platform/platform.h"

namespace vct::cli {

namespace {

using nlohmann::ordered_json;

struct BenchOptions {
    std::string scene, out, json;
    std::string preset = "thesis";
    std::string size = "400x400";
    std::string camera, light;
    std::string backend = "egl";
    int device = -1;
    int shadowMap = 512;
    int repeat = 3;
};

std::vector<std::string> renderArguments(const BenchOptions& options, const BenchConfig& config,
                                         const TemporaryFolder& folder) {
    std::ostringstream angle;
    angle << config.coneAngleDeg;
    std::vector<std::string> arguments{"render",
                                       options.scene,
                                       "--out=" + folder.file("pictures"),
                                       "--timings=" + folder.file("timings.json"),
                                       "--mode=" + config.modes,
                                       "--grid=" + std::to_string(config.grid),
                                       "--cone-angle=" + angle.str(),
                                       "--preset=" + options.preset,
                                       "--size=" + options.size,
                                       "--shadow-map=" + std::to_string(options.shadowMap),
                                       "--backend=" + options.backend};
    if (!options.camera.empty()) arguments.push_back("--camera=" + options.camera);
    if (!options.light.empty()) arguments.push_back("--light=" + options.light);
    if (options.device >= 0) arguments.push_back("--device=" + std::to_string(options.device));
    return arguments;
}

ordered_json timingsOf(const BenchOptions& options, const BenchConfig& config,
                       const TemporaryFolder& folder) {
    runSelf(renderArguments(options, config, folder), folder.file("log"));
    std::ifstream file(folder.file("timings.json"));
    return ordered_json::parse(file);
}

void bench(const BenchOptions& options) {
    sizeFromText(options.size);
    backendFromName(options.backend);
    presetSettings(options.preset);
    std::optional<OutputFolder> out;
    if (!options.out.empty()) out.emplace(options.out);
    if (!options.json.empty()) requireWritableFile(options.json);

    const std::vector<BenchConfig>& configs = benchConfigs();
    const std::size_t count = configs.size() * static_cast<std::size_t>(options.repeat);
    std::size_t done = 0;
    ordered_json common;
    Measurements measurements;
    // Every configuration once before any comes again: a machine that slows down meanwhile slows all of them.
    for (int run = 1; run <= options.repeat; ++run)
        for (const BenchConfig& config : configs) {
            const std::string name =
                config.name + ", run " + std::to_string(run) + " of " + std::to_string(options.repeat);
            std::fprintf(stderr, "[%zu/%zu] %s\n", ++done, count, name.c_str());
            try {
                const TemporaryFolder folder;
                const ordered_json timings = timingsOf(options, config, folder);
                if (common.empty()) common = timings;
                collect(timings, config, measurements);
            } catch (const std::exception& error) {
                throw Error("bench (" + name + "): " + error.what());
            }
        }

    const ordered_json json = benchJson(common, measurements, "processes");
    if (!options.json.empty()) writeJson(options.json, json);
    const std::string text = benchText(json, measurements);
    if (out) {
        writeJson(out->file("bench.json"), json);
        const std::string path = out->file("bench.txt");
        replaceFile(path, Bytes(text.begin(), text.end()));
        out->keep();
    }
    std::fputs(text.c_str(), stdout);
}

}  // namespace

void addBench(CLI::App& app, int&) {
    CLI::App* command = app.add_subcommand("bench", "Measure the thesis's tables 5.2 to 5.5 here");
    auto options = std::make_shared<BenchOptions>();
    command->footer(
        "Prints the tables, each with the thesis's rows beside those measured here. Runs 5 processes for "
        "each\n"
        "--repeat, one after the other; use the machine for nothing else meanwhile. docs/timings.md says "
        "more.");
    command->add_option("scene", options->scene, "Scene, .gltf or .glb")->required();
    command->add_option("--out", options->out, "Folder for bench.json and bench.txt; made if missing");
    command->add_option("--json", options->json, "Write the tables and every measurement to FILE");
    command->add_option("--repeat", options->repeat, "Fresh processes for each configuration")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
    command
        ->add_option("--preset", options->preset,
                     "Set of settings, at the tables' grids of 128^3 and 256^3: " + presetList())
        ->capture_default_str();
    command->add_option("--size", options->size, "Picture, WIDTHxHEIGHT")->capture_default_str();
    command->add_option("--shadow-map", options->shadowMap, "Texels along a side")->capture_default_str();
    command->add_option("--camera", options->camera, "As for render");
    command->add_option("--light", options->light, "As for render");
    command->add_option("--backend", options->backend, "egl, osmesa or zink")->capture_default_str();
    command->add_option("--device", options->device, "EGL device by index (`vct info --list-devices`)");
    command->callback([options] { bench(*options); });
}

}  // namespace vct::cli
