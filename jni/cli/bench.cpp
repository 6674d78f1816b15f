// vct bench: the thesis's tables 5.2 to 5.5 measured here, by its method (5.1.2): glFinish and the CPU's
// clock, frames to warm up, the average of 5 frames, all of it again in fresh processes.
#include <cstdio>
#include <fstream>
#include <optional>
#include <sstream>

#include "cli/bench_tables.h"
#include "cli/child_process.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/timings.h"
#include "core/error.h"
#include "core/files.h"
#include "platform/platform.h"

namespace vct::cli {

namespace {

using nlohmann::ordered_json;

// Version of the file that --json writes; docs/timings.md says when it changes.
constexpr int benchVersion = 1;

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

// What one process renders: modes that share a grid and an angle also share a process, as they differ in
// nothing that a process keeps.
struct ProcessConfig {
    std::string name;
    std::string modes;
    int grid;
    double coneAngleDeg;
};

const std::vector<ProcessConfig>& processConfigs() {
    static const std::vector<ProcessConfig> configs{
        {"scenes 1 to 5, 256^3, 5 degrees", "all", 256, 5.0},
        {"scenes 3 to 5, 128^3, 5 degrees", "3,4,5", 128, 5.0},
        {"scene 5, 256^3, 10 degrees", "5", 256, 10.0},
        {"scene 5, 256^3, 7.5 degrees", "5", 256, 7.5},
        {"scene 5, 256^3, 2.5 degrees", "5", 256, 2.5},
    };
    return configs;
}

std::vector<std::string> renderArguments(const BenchOptions& options, const ProcessConfig& config,
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

ordered_json timingsOf(const BenchOptions& options, const ProcessConfig& config,
                       const TemporaryFolder& folder) {
    runSelf(renderArguments(options, config, folder), folder.file("log"));
    std::ifstream file(folder.file("timings.json"));
    return ordered_json::parse(file);
}

double meanOf(const ordered_json& step) {
    double sum = 0.0;
    for (const ordered_json& sample : step.at("samples"))
        sum += sample.get<double>();
    return sum / static_cast<double>(step.at("samples").size());
}

void collect(const ordered_json& timings, const ProcessConfig& config, Measurements& measurements) {
    const auto add = [&](const std::string& mode, const ordered_json& steps) {
        StepMeans means{};
        for (int i = 0; i < stepCount; ++i)
            means.stepMs[static_cast<std::size_t>(i)] = meanOf(steps.at(stepName(static_cast<Step>(i))));
        means.totalMs = meanOf(steps.at("total"));
        measurements[{config.grid, config.coneAngleDeg, modesFromText(mode).front()}].push_back(means);
    };
    if (timings.contains("modes"))
        for (const auto& [mode, value] : timings.at("modes").items())
            add(mode, value.at("steps"));
    else
        add(timings.at("mode"), timings.at("steps"));
}

// What is common to all processes, from the first one's timings.
ordered_json header(ordered_json timings, int repeat) {
    for (const char* varies : {"grid", "cone_angle_deg"})
        timings.at("settings").erase(varies);
    ordered_json json;
    json["version"] = benchVersion;
    for (const char* key : {"program", "scene", "triangles", "driver", "machine", "settings", "method"})
        json[key] = timings.at(key);
    json["method"]["processes"] = repeat;
    json["method"]["statistic"] =
        "mean over processes of each process's mean over frames; min and max over processes";
    return json;
}

std::string headerText(const ordered_json& json, const BenchOptions& options) {
    std::ostringstream text;
    text << options.scene << ", " << json["triangles"] << " triangles, " << options.size
         << " pixels, shadow map " << options.shadowMap
         << "\nHere: " << json["driver"]["renderer"].get<std::string>() << ", "
         << json["driver"]["version"].get<std::string>() << "; " << json["machine"]["cpu"].get<std::string>()
         << ", " << json["machine"]["threads"] << " threads\nMean over " << options.repeat
         << " processes of the mean over " << timedFrames
         << " frames. Mobile, Laptop and Desktop are the thesis's: Mali-T880 MP12, GTX 860M, GTX 970\n";
    return text.str();
}

void bench(const BenchOptions& options) {
    sizeFromText(options.size);
    backendFromName(options.backend);
    presetSettings(options.preset);
    std::optional<OutputFolder> out;
    if (!options.out.empty()) out.emplace(options.out);
    if (!options.json.empty()) requireWritableFile(options.json);

    const std::vector<ProcessConfig>& configs = processConfigs();
    const std::size_t count = configs.size() * static_cast<std::size_t>(options.repeat);
    std::size_t done = 0;
    ordered_json json;
    Measurements measurements;
    // Every configuration once before any comes again: a machine that slows down meanwhile slows all of them.
    for (int run = 1; run <= options.repeat; ++run)
        for (const ProcessConfig& config : configs) {
            const std::string name =
                config.name + ", run " + std::to_string(run) + " of " + std::to_string(options.repeat);
            std::fprintf(stderr, "[%zu/%zu] %s\n", ++done, count, name.c_str());
            try {
                const TemporaryFolder folder;
                const ordered_json timings = timingsOf(options, config, folder);
                if (json.empty()) json = header(timings, options.repeat);
                collect(timings, config, measurements);
            } catch (const std::exception& error) {
                throw Error("bench (" + name + "): " + error.what());
            }
        }

    const std::vector<Table> tables = measuredTables(measurements);
    json["tables"] = tablesJson(tables);
    json["measurements"] = measurementsJson(measurements);
    if (!options.json.empty()) writeJson(options.json, json);
    const std::string text = headerText(json, options) + tablesText(tables);
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
    command->add_option("--preset", options->preset, "Set of settings: thesis")->capture_default_str();
    command->add_option("--size", options->size, "Picture, WIDTHxHEIGHT")->capture_default_str();
    command->add_option("--shadow-map", options->shadowMap, "Texels along a side")->capture_default_str();
    command->add_option("--camera", options->camera, "As for render");
    command->add_option("--light", options->light, "As for render");
    command->add_option("--backend", options->backend, "egl, osmesa or zink")->capture_default_str();
    command->add_option("--device", options->device, "EGL device by index (`vct info --list-devices`)");
    command->callback([options] { bench(*options); });
}

}  // namespace vct::cli
