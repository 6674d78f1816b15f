// The thesis's tables, with the rows measured here above those of the thesis.
#include <algorithm>
#include <numeric>

#include "engine/settings.h"
#include "engine/step_timer.h"
#include "lab/bench_report.h"
#include "lab/table.h"
#include "lab/timings.h"

namespace vct {

namespace {

using nlohmann::ordered_json;

struct TableRow {
    std::string platform;
    std::vector<double> valuesMs;
    // Minimum and maximum over the runs; empty in rows of the thesis.
    std::vector<double> minMs = {}, maxMs = {};
};

struct ThesisTable {
    std::string number;  // number in the thesis, such as "5.2"
    std::string title;
    std::vector<std::string> columns;
    std::vector<TableRow> rows;
};

// The numbers of the thesis (5.1.4 to 5.1.7), in milliseconds, copied without changes.
// Mobile: Samsung Galaxy S7 Edge, Mali-T880 MP12. Laptop: GeForce GTX 860M. Desktop: GeForce GTX 970.
std::vector<ThesisTable> thesisTables() {
    return {
        {"5.2",
         "Average time (ms) per frame for each scene; (*) when not voxelizing each frame",
         {"Scene 1", "Scene 2", "Scene 3", "Scene 4", "Scene 5"},
         {{"Mobile", {4.19, 6.38, 348.50, 393.19, 856.10}},
          {"Mobile(*)", {4.19, 6.38, 30.03, 74.72, 537.64}},
          {"Laptop", {1.11, 1.30, 6.06, 10.52, 27.16}},
          {"Laptop(*)", {1.11, 1.30, 2.24, 6.70, 23.34}},
          {"Desktop", {0.46, 0.64, 2.85, 4.81, 10.27}},
          {"Desktop(*)", {0.46, 0.64, 1.07, 3.03, 8.49}}}},
        {"5.3",
         "Average time (ms) per step for scene 5",
         {"CS", "RT", "V", "M", "Tr", "Tot"},
         {{"Mobile", {1.93, 2.53, 300.98, 17.48, 533.18, 856.10}},
          {"Laptop", {0.22, 0.89, 2.87, 0.96, 22.23, 27.16}},
          {"Desktop", {0.17, 0.35, 1.32, 0.47, 7.97, 10.27}}}},
        {"5.4",
         "Average time (ms) per frame of scene 5 for different shadow cone angles, when not voxelizing each "
         "frame",
         {"10 deg", "7.5 deg", "5 deg", "2.5 deg"},
         {{"Mobile", {291.57, 378.04, 536.82, 1076.49}},
          {"Laptop", {14.37, 17.11, 22.68, 38.31}},
          {"Desktop", {4.95, 5.88, 7.78, 12.50}}}},
        {"5.5",
         "Average time (ms) per step for voxel grids of 128^3 and 256^3; V and M over scenes 3 to 5, Tr for "
         "each",
         {"128 V", "128 M", "128 Tr 3", "128 Tr 4", "128 Tr 5", "256 V", "256 M", "256 Tr 3", "256 Tr 4",
          "256 Tr 5"},
         {{"Mobile", {247.64, 9.69, 14.59, 60.60, 484.38, 301.35, 17.93, 25.68, 70.32, 530.43}},
          {"Laptop", {0.75, 0.37, 0.64, 4.78, 19.08, 2.84, 0.99, 1.21, 5.54, 22.33}},
          {"Desktop", {0.51, 0.24, 0.31, 1.97, 7.00, 1.34, 0.48, 0.53, 2.26, 7.56}}}},
    };
}

// One number of a table: the sum of some steps of a frame, averaged over some modes.
struct Cell {
    int grid;
    double coneAngleDeg;
    std::vector<Output> modes;
    std::vector<Step> steps;
};

const std::vector<Step> wholeFrame{Step::shadowMap, Step::renderData, Step::voxelize, Step::inject,
                                   Step::mipmap,    Step::irradiance, Step::trace};
// The thesis's (*): the frame of a static scene, which is voxelized once.
const std::vector<Step> stepsAtRest{Step::shadowMap, Step::renderData, Step::trace};

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
        const ordered_json& modes = runs.timings[run].at("modes");
        for (const Output mode : cell.modes)
            if (modes.contains(outputName(mode)))
                for (const Step step : cell.steps)
                    sum += meanMs(modes.at(outputName(mode)).at("steps"), stepName(step));
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
    const std::vector<Output> last{Output::giConeShadow};
    const std::vector<Output> voxelModes{Output::ao, Output::gi, Output::giConeShadow};
    std::vector<Cell> cells;
    if (table == "5.2") {
        std::vector<Cell> still;
        for (const Output mode : allModes()) {
            cells.push_back({256, 5.0, {mode}, wholeFrame});
            still.push_back({256, 5.0, {mode}, stepsAtRest});
        }
        return {measuredRow("Here", cells, all), measuredRow("Here(*)", still, all)};
    }
    if (table == "5.3") {
        for (const Step step : {Step::shadowMap, Step::renderData, Step::voxelize, Step::mipmap, Step::trace})
            cells.push_back({256, 5.0, last, {step}});
        cells.push_back({256, 5.0, last, wholeFrame});
    } else if (table == "5.4") {
        for (const double angle : {10.0, 7.5, 5.0, 2.5})
            cells.push_back({256, angle, last, stepsAtRest});
    } else {
        for (const int grid : {128, 256}) {
            for (const Step step : {Step::voxelize, Step::mipmap})
                cells.push_back({grid, 5.0, voxelModes, {step}});
            for (const Output mode : voxelModes)
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
        for (const Output mode : modesFromText(runs.config.modes)) {
            ordered_json steps;
            const auto stepsOf = [&](const ordered_json& timings) -> const ordered_json& {
                return timings.at("modes").at(outputName(mode)).at("steps");
            };
            for (const auto& [step, unused] : stepsOf(runs.timings.front()).items()) {
                std::vector<double> runsMs;
                for (const ordered_json& timings : runs.timings)
                    runsMs.push_back(meanMs(stepsOf(timings), step));
                steps[step] = spreadJson("mean", mean(runsMs), "processes", runsMs);
            }
            json.push_back({{"grid", runs.config.grid},
                            {"cone_angle_deg", runs.config.coneAngleDeg},
                            {"mode", outputName(mode)},
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
            "Mobile, Laptop and Desktop are rows of the thesis: Mali-T880 MP12, GTX 860M, GTX 970\n"};
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
