#include "lab/preset_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "engine/settings.h"
#include "lab/step_timer.h"
#include "lab/timings.h"

namespace vct {

namespace {

using nlohmann::ordered_json;

// Of the file; docs/timings.md says when it changes.
constexpr int comparisonVersion = 1;
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

double rounded(double value) {
    return std::round(value * 1000.0) / 1000.0;
}

ordered_json spread(const std::vector<double>& processesMs) {
    ordered_json json{{"median", rounded(median(processesMs))},
                      {"min", rounded(*std::min_element(processesMs.begin(), processesMs.end()))},
                      {"max", rounded(*std::max_element(processesMs.begin(), processesMs.end()))},
                      {"processes", ordered_json::array()}};
    for (const double ms : processesMs)
        json["processes"].push_back(rounded(ms));
    return json;
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

ordered_json modeJson(const PresetRuns& runs, const std::string& mode) {
    const auto over = [&](const auto& ofSteps) {
        std::vector<double> processesMs;
        for (const ordered_json& timings : runs.timings)
            processesMs.push_back(ofSteps(timings.at("modes").at(mode).at("steps")));
        return spread(processesMs);
    };
    ordered_json json;
    for (const auto& [step, unused] : runs.timings.front().at("modes").at(mode).at("steps").items())
        json[step] =
            over([&, name = step](const ordered_json& steps) { return steps.at(name).at("median"); });
    json[voxelsStep] = over(voxelsMs);
    return json;
}

ordered_json presetJson(const PresetRuns& runs) {
    const ordered_json& first = runs.timings.front();
    ordered_json json{{"preset", runs.preset}, {"settings", first.at("settings")}};
    double bytes = 0.0;
    for (const ordered_json& resource : first.at("resources"))
        bytes += resource.at("bytes").get<double>();
    json["bytes"] = bytes;
    for (const auto& [mode, unused] : first.at("modes").items())
        json["modes"][mode] = modeJson(runs, mode);
    return json;
}

// null where the preset takes no time for a step.
ordered_json ratio(double of, double over) {
    return over > 0.0 && of > 0.0 ? ordered_json(rounded(of / over)) : ordered_json(nullptr);
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

using Rows = std::vector<std::vector<std::string>>;

std::string cell(const char* format, double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string ratioCell(const ordered_json& value) {
    return value.is_null() ? "-" : cell("%.2f", value.get<double>());
}

// The first row is the head. Padded, so that it can be read as it is, too.
std::string markdownTable(const Rows& rows) {
    std::string text;
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], row[i].size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t i = 0; i < widths.size(); ++i) {
            const std::string padding(widths[i] - rows[r][i].size(), ' ');
            text += i == 0 ? "| " + rows[r][i] + padding + " |" : " " + padding + rows[r][i] + " |";
        }
        text += "\n";
        if (r > 0) continue;
        for (std::size_t i = 0; i < widths.size(); ++i)
            text +=
                i == 0 ? "|-" + std::string(widths[i], '-') + "-|" : "-" + std::string(widths[i], '-') + ":|";
        text += "\n";
    }
    return text;
}

// A row for each preset, and one for each ratio.
Rows presetRows(const ordered_json& comparison, const std::string& head, const std::vector<Column>& columns) {
    Rows rows(1, {head});
    for (const Column& column : columns)
        rows[0].push_back(column.title);
    rows[0].emplace_back("GL memory, MB");
    for (const ordered_json& preset : comparison.at("presets")) {
        rows.push_back({preset.at("preset").get<std::string>() + ", " +
                        std::to_string(preset.at("settings").at("grid").get<int>()) + "^3"});
        for (const Column& column : columns)
            rows.back().push_back(
                cell("%.2f", preset.at("modes").at(column.mode).at(column.step).at("median")));
        rows.back().push_back(cell("%.1f", preset.at("bytes").get<double>() / 1e6));
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

ordered_json comparisonJson(const std::vector<PresetRuns>& presets) {
    const ordered_json& common = presets.front().timings.front();
    ordered_json json{{"version", comparisonVersion}};
    for (const char* key : {"program", "scene", "triangles", "driver", "machine", "method"})
        json[key] = common.at(key);
    json["method"]["fresh"] = "processes";
    json["method"]["processes"] = presets.front().timings.size();
    json["method"]["statistic"] =
        "median over processes, the presets in turn, of each one's median over frames; milliseconds";
    json["presets"] = ordered_json::array();
    for (const PresetRuns& runs : presets)
        json["presets"].push_back(presetJson(runs));
    json["ratios"] = ordered_json::array();
    for (std::size_t i = 1; i < presets.size(); ++i)
        json["ratios"].push_back(ratiosJson(json["presets"][0], json["presets"][i]));
    return json;
}

std::string comparisonText(const ordered_json& comparison) {
    const ordered_json& settings = comparison.at("presets").at(0).at("settings");
    std::ostringstream text;
    text << comparison.at("scene").get<std::string>() << ", " << comparison.at("triangles") << " triangles, "
         << settings.at("width") << "x" << settings.at("height") << " pixels, shadow map "
         << settings.at("shadow_map")
         << "\nHere: " << comparison.at("driver").at("renderer").get<std::string>() << ", "
         << comparison.at("driver").at("version").get<std::string>() << "; "
         << comparison.at("machine").at("cpu").get<std::string>() << ", "
         << comparison.at("machine").at("threads") << " threads\nMilliseconds; "
         << comparison.at("method").at("processes") << " processes of " << timedFrames
         << " frames each, the presets in turn; medians, and how many times the first preset's\n";
    text << "\n" << markdownTable(presetRows(comparison, "preset", summaryColumns()));
    for (const Mode mode : {Mode::ao, Mode::gi, Mode::giConeShadow}) {
        const std::string head = "mode " + std::to_string(static_cast<int>(mode)) + ", " + modeName(mode);
        text << "\n" << markdownTable(presetRows(comparison, head, stepColumns(mode)));
    }
    return text.str();
}

}  // namespace vct
