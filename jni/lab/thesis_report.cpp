// What the thesis measured, measured here, and the two side by side.
#include <algorithm>
#include <numeric>

#include "engine/settings.h"
#include "lab/bench_report.h"
#include "lab/step_timer.h"
#include "lab/table.h"
#include "lab/thesis_tables.h"
#include "lab/timings.h"

namespace vct {

namespace {

using nlohmann::ordered_json;

// A number of a table: the sum of some steps of a frame, averaged over some modes.
struct Cell {
    int grid;
    double coneAngleDeg;
    std::vector<Mode> modes;
    std::vector<Step> steps;
};

const std::vector<Step> wholeFrame{Step::shadowMap, Step::renderData, Step::voxelize,
                                   Step::mipmap,    Step::irradiance, Step::trace};
// The thesis's (*): the frame of a static scene, which is voxelized once.
const std::vector<Step> withoutVoxelizing{Step::shadowMap, Step::renderData, Step::trace};

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double meanMs(const ordered_json& steps, const std::string& step) {
    return mean(steps.at(step).at("samples").get<std::vector<double>>());
}

double valueMs(const std::vector<BenchRuns>& all, const Cell& cell, std::size_t run) {
    double sum = 0.0;
    for (const BenchRuns& runs : all) {
        if (runs.config.grid != cell.grid || runs.config.coneAngleDeg != cell.coneAngleDeg) continue;
        for (const Mode mode : cell.modes)
            if (const ordered_json* steps = stepsOf(runs.timings[run], modeName(mode)))
                for (const Step step : cell.steps)
                    sum += meanMs(*steps, stepName(step));
    }
    return sum / static_cast<double>(cell.modes.size());
}

TableRow measuredRow(const std::string& platform, const std::vector<Cell>& cells,
                     const std::vector<BenchRuns>& all) {
    TableRow row{platform, {}};
    for (const Cell& cell : cells) {
        std::vector<double> values;
        for (std::size_t run = 0; run < all.front().timings.size(); ++run)
            values.push_back(valueMs(all, cell, run));
        row.valuesMs.push_back(mean(values));
        row.minMs.push_back(*std::min_element(values.begin(), values.end()));
        row.maxMs.push_back(*std::max_element(values.begin(), values.end()));
    }
    return row;
}

std::vector<TableRow> measuredRows(const std::string& table, const std::vector<BenchRuns>& all) {
    const std::vector<Mode> last{Mode::giConeShadow};
    const std::vector<Mode> voxelModes{Mode::ao, Mode::gi, Mode::giConeShadow};
    std::vector<Cell> cells;
    if (table == "5.2") {
        std::vector<Cell> still;
        for (const Mode mode : allModes()) {
            cells.push_back({256, 5.0, {mode}, wholeFrame});
            still.push_back({256, 5.0, {mode}, withoutVoxelizing});
        }
        return {measuredRow("Here", cells, all), measuredRow("Here(*)", still, all)};
    }
    if (table == "5.3") {
        for (const Step step : {Step::shadowMap, Step::renderData, Step::voxelize, Step::mipmap, Step::trace})
            cells.push_back({256, 5.0, last, {step}});
        cells.push_back({256, 5.0, last, wholeFrame});
    } else if (table == "5.4") {
        for (const double angle : {10.0, 7.5, 5.0, 2.5})
            cells.push_back({256, angle, last, withoutVoxelizing});
    } else {
        for (const int grid : {128, 256}) {
            for (const Step step : {Step::voxelize, Step::mipmap})
                cells.push_back({grid, 5.0, voxelModes, {step}});
            for (const Mode mode : voxelModes)
                cells.push_back({grid, 5.0, {mode}, {Step::trace}});
        }
    }
    return {measuredRow("Here", cells, all)};
}

ordered_json rowJson(const TableRow& row) {
    const bool measured = !row.minMs.empty();
    ordered_json json{{"platform", row.platform},
                      {"source", measured ? "measured" : "thesis"},
                      {"values", roundedJson(row.valuesMs)}};
    if (measured) {
        json["min"] = roundedJson(row.minMs);
        json["max"] = roundedJson(row.maxMs);
    }
    return json;
}

ordered_json measurementsJson(const std::vector<BenchRuns>& all) {
    ordered_json json = ordered_json::array();
    for (const BenchRuns& runs : all)
        for (const Mode mode : modesFromText(runs.config.modes)) {
            ordered_json steps;
            for (const auto& [step, unused] : stepsOf(runs.timings.front(), modeName(mode))->items()) {
                std::vector<double> runsMs;
                for (const ordered_json& timings : runs.timings)
                    runsMs.push_back(meanMs(*stepsOf(timings, modeName(mode)), step));
                steps[step] = spreadJson("mean", mean(runsMs), "processes", runsMs);
            }
            json.push_back({{"grid", runs.config.grid},
                            {"cone_angle_deg", runs.config.coneAngleDeg},
                            {"mode", modeName(mode)},
                            {"steps", std::move(steps)}});
        }
    return json;
}

std::string tableText(const ThesisTable& table) {
    TableRows rows{{""}};
    rows[0].insert(rows[0].end(), table.columns.begin(), table.columns.end());
    for (const TableRow& row : table.rows) {
        rows.push_back({row.platform});
        for (const double ms : row.valuesMs)
            rows.back().push_back(cellText("%.2f", ms));
    }
    return "\nTable " + table.number + ": " + table.title + "\n\n" + markdownTable(rows);
}

}  // namespace

std::vector<BenchConfig> thesisConfigs() {
    return {
        {"scenes 1 to 5, 256^3, 5 degrees", "thesis", "all", 256, 5.0},
        {"scenes 3 to 5, 128^3, 5 degrees", "thesis", "3,4,5", 128, 5.0},
        {"scene 5, 256^3, 10 degrees", "thesis", "5", 256, 10.0},
        {"scene 5, 256^3, 7.5 degrees", "thesis", "5", 256, 7.5},
        {"scene 5, 256^3, 2.5 degrees", "thesis", "5", 256, 2.5},
    };
}

BenchReport thesisReport(const std::vector<BenchRuns>& all) {
    BenchReport report{
        benchHeadJson(all, "mean over renderers of each one's mean over frames; min and max over renderers"),
        benchHeadText(all) +
            "Mobile, Laptop and Desktop are the thesis's: Mali-T880 MP12, GTX 860M, GTX 970\n"};
    report.json["settings"] = all.front().timings.front().at("settings");
    for (const char* varies : {"grid", "cone_angle_deg"})
        report.json["settings"].erase(varies);
    for (ThesisTable table : thesisTables()) {
        const std::vector<TableRow> here = measuredRows(table.number, all);
        table.rows.insert(table.rows.begin(), here.begin(), here.end());
        ordered_json rows = ordered_json::array();
        for (const TableRow& row : table.rows)
            rows.push_back(rowJson(row));
        report.json["tables"][table.number] = {
            {"title", table.title}, {"columns", table.columns}, {"rows", std::move(rows)}};
        report.text += tableText(table);
    }
    report.json["measurements"] = measurementsJson(all);
    return report;
}

}  // namespace vct
