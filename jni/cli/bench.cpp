// vct bench: the thesis's tables 5.2 to 5.5 measured here, or presets side by side, by the thesis's method
// (5.1.2): glFinish and the CPU's clock, frames to warm up, 5 frames, all of it again in fresh processes.
#include <cstdio>
#include <fstream>
#include <functional>
#include <optional>

#include "cli/backend_option.h"
#include "cli/child_process.h"
#include "cli/commands.h"
#include "cli/grid_option.h"
#include "cli/numbers.h"
#include "cli/output.h"
#include "core/error.h"
#include "core/files.h"
#include "core/number_text.h"
#include "lab/bench_plan.h"
#include "lab/options.h"
#include "lab/preset_comparison.h"
#include "lab/timings.h"
#include "platform/platform.h"

namespace vct::cli {

namespace {

using nlohmann::ordered_json;

struct BenchOptions {
    std::string scene, out, json;
    std::vector<std::string> presets{"thesis"};
    GridOption grid;
    std::string size = "400x400";
    std::string camera, light;
    BackendOption backend;
    int shadowMap = 512;
    int repeat = 3;
};

std::vector<std::string> renderArguments(const BenchOptions& options, const std::string& preset,
                                         const BenchConfig& config, const TemporaryFolder& folder) {
    std::vector<std::string> arguments{"render",
                                       options.scene,
                                       "--out=" + folder.file("pictures"),
                                       "--timings=" + folder.file("timings.json"),
                                       "--revoxelize",
                                       "--mode=" + config.modes,
                                       options.grid.argument(config.grid),
                                       "--cone-angle=" + numberText(config.coneAngleDeg),
                                       "--preset=" + preset,
                                       "--size=" + options.size,
                                       "--shadow-map=" + std::to_string(options.shadowMap),
                                       "--backend=" + options.backend.name};
    if (!options.camera.empty()) arguments.push_back("--camera=" + options.camera);
    if (!options.light.empty()) arguments.push_back("--light=" + options.light);
    if (options.backend.device >= 0)
        arguments.push_back("--device=" + std::to_string(options.backend.device));
    return arguments;
}

struct Process {
    std::string preset;
    BenchConfig config;
};

// timings.json of each process, --repeat times. Every process once before any comes again: a machine that
// slows down meanwhile slows all of them.
void runInTurn(const BenchOptions& options, const std::vector<Process>& processes,
               const std::function<void(std::size_t process, const ordered_json& timings)>& take) {
    const std::size_t count = processes.size() * static_cast<std::size_t>(options.repeat);
    for (std::size_t done = 0; done < count; ++done) {
        const Process& process = processes[done % processes.size()];
        const std::string name = process.config.name + ", run " +
                                 std::to_string(done / processes.size() + 1) + " of " +
                                 std::to_string(options.repeat);
        std::fprintf(stderr, "[%zu/%zu] %s\n", done + 1, count, name.c_str());
        try {
            const TemporaryFolder folder;
            runSelf(renderArguments(options, process.preset, process.config, folder), folder.file("log"));
            std::ifstream file(folder.file("timings.json"));
            take(done % processes.size(), ordered_json::parse(file));
        } catch (const std::exception& error) {
            throw Error("bench (" + name + "): " + error.what());
        }
    }
}

struct Result {
    ordered_json json;
    std::string text;
};

Result thesisTablesHere(const BenchOptions& options) {
    std::vector<Process> processes;
    for (const BenchConfig& config : benchConfigs())
        processes.push_back({"thesis", config});
    ordered_json common;
    Measurements measurements;
    runInTurn(options, processes, [&](std::size_t process, const ordered_json& timings) {
        if (common.empty()) common = timings;
        collect(timings, processes[process].config, measurements);
    });
    const ordered_json json = benchJson(common, measurements, "processes");
    return {json, benchText(json, measurements)};
}

Result presetsHere(const BenchOptions& options) {
    std::vector<Process> processes;
    std::vector<PresetRuns> runs;
    for (const std::string& preset : options.presets) {
        BenchConfig config = benchConfigs().front();
        config.grid = presetSettings(preset).grid;
        config.name = preset + ", scenes 1 to 5, " + options.grid.name(config.grid);
        processes.push_back({preset, config});
        runs.push_back({preset, {}});
    }
    runInTurn(options, processes, [&](std::size_t process, const ordered_json& timings) {
        runs[process].timings.push_back(timings);
    });
    const ordered_json json = comparisonJson(runs);
    return {json, comparisonText(json)};
}

void bench(const BenchOptions& options) {
    sizeFromText(options.size);
    backendFromName(options.backend.name);
    for (const std::string& preset : options.presets) {
        Settings settings = presetSettings(preset);
        options.grid.applyNumber(settings);
        validate(settings);
    }
    std::optional<OutputFolder> out;
    if (!options.out.empty()) out.emplace(options.out);
    if (!options.json.empty()) requireWritableFile(options.json);

    const bool tables = options.presets == std::vector<std::string>{"thesis"} && !options.grid.given();
    const Result result = tables ? thesisTablesHere(options) : presetsHere(options);
    if (!options.json.empty()) writeJson(options.json, result.json);
    if (out) {
        writeJson(out->file("bench.json"), result.json);
        replaceFile(out->file("bench.txt"), Bytes(result.text.begin(), result.text.end()));
        out->keep();
    }
    std::fputs(result.text.c_str(), stdout);
}

}  // namespace

void addBench(CLI::App& app, int&) {
    CLI::App* command =
        app.add_subcommand("bench", "Measure the thesis's tables 5.2 to 5.5, or presets side by side");
    auto options = std::make_shared<BenchOptions>();
    command->footer(
        "Prints the thesis's tables, each with its rows beside those measured here, in 5 processes for each "
        "--repeat.\n"
        "Of other or several presets it prints what each step takes, and how many times that of the first "
        "preset:\n"
        "  vct bench assets/cornell.glb --preset thesis,mobile,quality\n"
        "One process runs at a time; use the machine for nothing else meanwhile. docs/timings.md says more.");
    command->add_option("scene", options->scene, "Scene, .gltf or .glb")->required();
    command->add_option("--out", options->out, "Folder for bench.json and bench.txt; made if missing");
    command->add_option("--json", options->json, "Write the tables and every measurement to FILE");
    command->add_option("--repeat", options->repeat, "Fresh processes for each configuration")
        ->check(number("a whole number from 1 to 100", [](double v) { return v >= 1.0 && v <= 100.0; }))
        ->capture_default_str();
    command
        ->add_option(
            "--preset", options->presets,
            "Sets of settings, several with commas: " + presetList() + "; thesis alone gives the tables")
        ->delimiter(',')
        ->capture_default_str();
    options->grid.addTo(*command);
    command->add_option("--size", options->size, "Picture, WIDTHxHEIGHT")->capture_default_str();
    command->add_option("--shadow-map", options->shadowMap, "Texels along a side")->capture_default_str();
    command->add_option("--camera", options->camera, "As for render");
    command->add_option("--light", options->light, "As for render");
    options->backend.addTo(*command);
    command->callback([options] { bench(*options); });
}

}  // namespace vct::cli
