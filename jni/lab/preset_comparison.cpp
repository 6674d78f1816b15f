// Presets side by side: what each step of a frame costs, and how many times that of the first.
#include "engine/settings.h"
#include "lab/bench_report.h"
#include "lab/step_timer.h"
#include "lab/table.h"
#include "lab/timings.h"

namespace vct {

namespace {

using nlohmann::ordered_json;

constexpr const char* voxelsStep = "voxelize_mipmap";

struct Column {
    std::string title, mode, step;
};

std::vector<Column> summaryColumns() {
    const std::string four = modeName(Mode::gi);
    const std::string five = modeName(Mode::giConeShadow);
    return {{"voxelize + mipmap", five, voxelsStep}, {"irradiance", five, "irradiance"},
            {"trace, mode 4", four, "trace"},        {"trace, mode 5", five, "trace"},
            {"frame, mode 4", four, "total"},        {"frame, mode 5", five, "total"}};
}

std::vector<Column> stepColumns(Mode mode) {
    const std::string name = modeName(mode);
    return {{"shadow map", name, "shadow_map"},
            {"G-buffer", name, "render_data"},
            {"voxelize + mipmap", name, voxelsStep},
            {"irradiance", name, "irradiance"},
            {"trace", name, "trace"},
            {"frame", name, "total"}};
}

// Voxelizing and the mip levels together, median over the frames.
double voxelsMs(const ordered_json& steps) {
    std::vector<double> framesMs;
    const ordered_json& voxelize = steps.at("voxelize").at("samples");
    const ordered_json& mipmap = steps.at("mipmap").at("samples");
    for (std::size_t i = 0; i < voxelize.size(); ++i)
        framesMs.push_back(voxelize[i].get<double>() + mipmap.at(i).get<double>());
    return median(framesMs);
}

ordered_json modeJson(const BenchRuns& runs, const std::string& mode) {
    const auto spread = [&](const auto& ofSteps) {
        std::vector<double> runsMs;
        for (const ordered_json& timings : runs.timings)
            runsMs.push_back(ofSteps(*stepsOf(timings, mode)));
        return spreadJson("median", median(runsMs), "processes", runsMs);
    };
    ordered_json json;
    for (const auto& [step, unused] : stepsOf(runs.timings.front(), mode)->items())
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
    for (const Mode mode : modesFromText(runs.config.modes))
        json["modes"][modeName(mode)] = modeJson(runs, modeName(mode));
    return json;
}

// null where the preset takes no time for a step.
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

// A row for each preset, and one for each ratio.
TableRows presetRows(const ordered_json& comparison, const std::string& head,
                     const std::vector<Column>& columns) {
    TableRows rows{{head}};
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

BenchReport comparisonReport(const std::vector<BenchRuns>& presets) {
    BenchReport report{
        benchHeadJson(presets,
                      "median over renderers, the presets in turn, of each one's median over frames; "
                      "milliseconds"),
        benchHeadText(presets) + "The presets in turn; medians, and how many times the first preset's\n"};
    ordered_json& json = report.json;
    json["presets"] = ordered_json::array();
    for (const BenchRuns& runs : presets)
        json["presets"].push_back(presetJson(runs));
    json["ratios"] = ordered_json::array();
    for (std::size_t i = 1; i < presets.size(); ++i)
        json["ratios"].push_back(ratiosJson(json["presets"][0], json["presets"][i]));

    report.text += "\n" + markdownTable(presetRows(json, "preset", summaryColumns()));
    for (const Mode mode : {Mode::ao, Mode::gi, Mode::giConeShadow}) {
        const std::string head = "mode " + std::to_string(static_cast<int>(mode)) + ", " + modeName(mode);
        report.text += "\n" + markdownTable(presetRows(json, head, stepColumns(mode)));
    }
    return report;
}

}  // namespace vct
