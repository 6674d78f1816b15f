// Compares presets: the time of each step, and the ratios of the first preset's times to the others'.
#include "lab/bench_report.h"

#include <sstream>

#include "engine/settings.h"
#include "engine/step_timer.h"
#include "lab/table.h"
#include "lab/timings.h"

namespace vct {

using nlohmann::ordered_json;

namespace {

constexpr const char* voxelsStep = "voxelize_mipmap";

struct Column {
    std::string title, mode, step;
};

// The columns of the comparison.
std::vector<Column> columnsOfATable() {
    const std::string four = outputName(Output::gi);
    const std::string five = outputName(Output::giConeShadow);
    return {{"voxelize + mipmap", five, voxelsStep}, {"irradiance", five, "irradiance"},
            {"trace, mode 4", four, "trace"},        {"trace, mode 5", five, "trace"},
            {"frame, mode 4", four, "total"},        {"frame, mode 5", five, "total"}};
}

// Time of voxelization and mip levels together: the median over the frames.
double voxelsMs(const ordered_json& steps) {
    std::vector<double> framesMs;
    const ordered_json& voxelize = steps.at("voxelize").at("samples");
    const ordered_json& mipmap = steps.at("mipmap").at("samples");
    for (std::size_t i = 0; i < voxelize.size(); ++i)
        framesMs.push_back(voxelize[i].get<double>() + mipmap.at(i).get<double>());
    return median(framesMs);
}

ordered_json modeJson(const BenchRuns& runs, const std::string& mode) {
    const auto spread = [&](const auto& stepTime) {
        std::vector<double> runsMs;
        for (const ordered_json& timings : runs.timings)
            runsMs.push_back(stepTime(timings.at("modes").at(mode).at("steps")));
        return spreadJson("median", median(runsMs), "processes", runsMs);
    };
    ordered_json json;
    for (const auto& [step, unused] : runs.timings.front().at("modes").at(mode).at("steps").items())
        json[step] = spread([name = step](const ordered_json& steps) { return steps.at(name).at("median"); });
    json[voxelsStep] = spread(voxelsMs);
    return json;
}

ordered_json presetJson(const BenchRuns& runs) {
    const ordered_json& first = runs.timings.front();
    ordered_json json{{"preset", runs.config.preset}, {"settings", first.at("settings")}};
    double bytes = 0.0;
    for (const ordered_json& resource : first.at("resources"))
        bytes += resource.at("bytes").get<double>();
    json["bytes"] = bytes;
    for (const Output mode : modesFromText(runs.config.modes))
        json["modes"][outputName(mode)] = modeJson(runs, outputName(mode));
    return json;
}

// The ratio, or null if a preset takes no time for the step.
ordered_json ratio(double of, double over) {
    return over > 0.0 && of > 0.0 ? ordered_json(roundedMs(of / over)) : ordered_json(nullptr);
}

ordered_json ratiosJson(const ordered_json& first, const ordered_json& other) {
    ordered_json json{{"of", first.at("preset")},
                      {"over", other.at("preset")},
                      {"bytes", ratio(first.at("bytes"), other.at("bytes"))}};
    for (const auto& [mode, steps] : first.at("modes").items())
        for (const auto& [step, times] : steps.items())
            json["modes"][mode][step] =
                ratio(times.at("median"), other.at("modes").at(mode).at(step).at("median"));
    return json;
}

std::string ratioCell(const ordered_json& value) {
    return value.is_null() ? "-" : cellText("%.2f", value.get<double>());
}

// Rows of the table: one for each preset, and one for each ratio.
TableRows presetRows(const ordered_json& comparison) {
    const std::vector<Column> columns = columnsOfATable();
    TableRows rows{{"preset"}};
    for (const Column& column : columns)
        rows[0].push_back(column.title);
    rows[0].emplace_back("GL memory, MB");
    for (const ordered_json& preset : comparison.at("presets")) {
        rows.push_back({preset.at("preset").get<std::string>() + ", " +
                        std::to_string(preset.at("settings").at("grid").get<int>()) + "^3"});
        for (const Column& column : columns)
            rows.back().push_back(
                cellText("%.2f", preset.at("modes").at(column.mode).at(column.step).at("median")));
        rows.back().push_back(cellText("%.1f", preset.at("bytes").get<double>() / 1e6));
    }
    for (const ordered_json& ratios : comparison.at("ratios")) {
        rows.push_back({ratios.at("of").get<std::string>() + " / " + ratios.at("over").get<std::string>()});
        for (const Column& column : columns)
            rows.back().push_back(ratioCell(ratios.at("modes").at(column.mode).at(column.step)));
        rows.back().push_back(ratioCell(ratios.at("bytes")));
    }
    return rows;
}

}  // namespace

ordered_json benchHeadJson(const std::vector<BenchRuns>& all, const std::string& statistic) {
    const ordered_json& first = all.front().timings.front();
    ordered_json json{{"version", 1}};
    for (const char* key : {"program", "scene", "triangles", "driver", "machine", "method"})
        json[key] = first.at(key);
    json["method"]["fresh"] = "renderers";
    json["method"]["processes"] = all.front().timings.size();
    json["method"]["statistic"] = statistic;
    return json;
}

std::string benchHeadText(const std::vector<BenchRuns>& all) {
    const ordered_json& first = all.front().timings.front();
    const ordered_json& settings = first.at("settings");
    const std::string sky = settings.at("sky");
    std::ostringstream text;
    text << first.at("scene").get<std::string>() << ", " << first.at("triangles") << " triangles, "
         << settings.at("width") << "x" << settings.at("height") << " pixels, shadow map "
         << settings.at("shadow_map") << (sky == "dark" ? "" : ", sky: " + sky)
         << "\nHere: " << first.at("driver").at("renderer").get<std::string>() << ", "
         << first.at("driver").at("version").get<std::string>() << "; "
         << first.at("machine").at("cpu").get<std::string>() << ", " << first.at("machine").at("threads")
         << " threads\nMilliseconds; each number comes from " << all.front().timings.size()
         << " runs, each with a new renderer and " << first.at("method").at("frames") << " frames\n";
    return text.str();
}

BenchReport comparisonReport(const std::vector<BenchRuns>& presets) {
    BenchReport report{
        benchHeadJson(presets,
                      "median over renderers, the presets in turn, of each one's median over frames; "
                      "milliseconds"),
        benchHeadText(presets) +
            "Medians; the presets ran in turn. Ratios: time of the first preset over that of the other\n"};
    ordered_json& json = report.json;
    json["presets"] = ordered_json::array();
    for (const BenchRuns& runs : presets)
        json["presets"].push_back(presetJson(runs));
    json["ratios"] = ordered_json::array();
    for (std::size_t i = 1; i < presets.size(); ++i)
        json["ratios"].push_back(ratiosJson(json["presets"][0], json["presets"][i]));

    report.text += "\n" + markdownTable(presetRows(json));
    return report;
}

}  // namespace vct
