#include "lab/bench_plan.h"

#include <sstream>

#include "lab/timings.h"

namespace vct {

namespace {

using nlohmann::ordered_json;

// Of bench.json; docs/timings.md says when it changes.
constexpr int benchVersion = 1;

double meanOf(const ordered_json& step) {
    double sum = 0.0;
    for (const ordered_json& sample : step.at("samples"))
        sum += sample.get<double>();
    return sum / static_cast<double>(step.at("samples").size());
}

}  // namespace

const std::vector<BenchConfig>& benchConfigs() {
    static const std::vector<BenchConfig> configs{
        {"scenes 1 to 5, 256^3, 5 degrees", "all", 256, 5.0},
        {"scenes 3 to 5, 128^3, 5 degrees", "3,4,5", 128, 5.0},
        {"scene 5, 256^3, 10 degrees", "5", 256, 10.0},
        {"scene 5, 256^3, 7.5 degrees", "5", 256, 7.5},
        {"scene 5, 256^3, 2.5 degrees", "5", 256, 2.5},
    };
    return configs;
}

void collect(const ordered_json& timings, const BenchConfig& config, Measurements& measurements) {
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

ordered_json benchJson(const ordered_json& timings, const Measurements& measurements,
                       const std::string& runs) {
    ordered_json settings = timings.at("settings");
    for (const char* varies : {"grid", "cone_angle_deg"})
        settings.erase(varies);
    ordered_json json;
    json["version"] = benchVersion;
    for (const char* key : {"program", "scene", "triangles", "driver", "machine"})
        json[key] = timings.at(key);
    json["settings"] = std::move(settings);
    json["method"] = timings.at("method");
    json["method"]["fresh"] = runs;
    json["method"]["processes"] = measurements.begin()->second.size();
    json["method"]["statistic"] =
        "mean over " + runs + " of each one's mean over frames; min and max over " + runs;
    const std::vector<Table> tables = measuredTables(measurements);
    json["tables"] = tablesJson(tables);
    json["measurements"] = measurementsJson(measurements);
    return json;
}

std::string benchText(const ordered_json& bench, const Measurements& measurements) {
    const ordered_json& settings = bench.at("settings");
    std::ostringstream text;
    text << bench.at("scene").get<std::string>() << ", " << bench.at("triangles") << " triangles, "
         << settings.at("width") << "x" << settings.at("height") << " pixels, shadow map "
         << settings.at("shadow_map") << "\nHere: " << bench.at("driver").at("renderer").get<std::string>()
         << ", " << bench.at("driver").at("version").get<std::string>() << "; "
         << bench.at("machine").at("cpu").get<std::string>() << ", " << bench.at("machine").at("threads")
         << " threads\n"
         << bench.at("method").at("statistic").get<std::string>() << "; "
         << bench.at("method").at("processes") << " of " << timedFrames
         << " frames each.\nMobile, Laptop and Desktop are the thesis's: Mali-T880 MP12, GTX 860M, GTX 970\n";
    return text.str() + tablesText(measuredTables(measurements));
}

}  // namespace vct
