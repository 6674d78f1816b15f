#include "lab/bench_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>

namespace vct {

namespace {

using nlohmann::ordered_json;

// A cell's value in one process.
using Cell = std::function<double(std::size_t process)>;

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Row measuredRow(const std::string& platform, const std::vector<Cell>& cells, std::size_t processes) {
    Row row{platform, {}, {}, {}};
    for (const Cell& cell : cells) {
        std::vector<double> values;
        for (std::size_t process = 0; process < processes; ++process)
            values.push_back(cell(process));
        row.valuesMs.push_back(mean(values));
        row.minMs.push_back(*std::min_element(values.begin(), values.end()));
        row.maxMs.push_back(*std::max_element(values.begin(), values.end()));
    }
    return row;
}

constexpr Mode voxelModes[] = {Mode::ao, Mode::gi, Mode::giConeShadow};

std::vector<Row> measuredRows(const std::string& table, const Measurements& measurements) {
    const std::size_t processes = measurements.begin()->second.size();
    const auto of = [&](int grid, double angle, Mode mode) -> const std::vector<StepMeans>& {
        return measurements.at({grid, angle, mode});
    };
    std::vector<Cell> cells;
    if (table == "5.2") {
        std::vector<Cell> withoutVoxelizing;
        for (Mode mode : allModes()) {
            const std::vector<StepMeans>& runs = of(256, 5.0, mode);
            cells.emplace_back([&runs](std::size_t p) { return runs[p].totalMs; });
            withoutVoxelizing.emplace_back([&runs](std::size_t p) { return runs[p].withoutVoxelizingMs(); });
        }
        return {measuredRow("Here", cells, processes), measuredRow("Here(*)", withoutVoxelizing, processes)};
    }
    if (table == "5.3") {
        const std::vector<StepMeans>& runs = of(256, 5.0, Mode::giConeShadow);
        for (Step step : {Step::shadowMap, Step::renderData, Step::voxelize, Step::mipmap, Step::trace})
            cells.emplace_back([&runs, step](std::size_t p) { return runs[p][step]; });
        cells.emplace_back([&runs](std::size_t p) { return runs[p].totalMs; });
    } else if (table == "5.4") {
        for (double angle : {10.0, 7.5, 5.0, 2.5}) {
            const std::vector<StepMeans>& runs = of(256, angle, Mode::giConeShadow);
            cells.emplace_back([&runs](std::size_t p) { return runs[p].withoutVoxelizingMs(); });
        }
    } else {
        for (int grid : {128, 256}) {
            for (Step step : {Step::voxelize, Step::mipmap})
                cells.emplace_back([&of, grid, step](std::size_t p) {
                    double sum = 0.0;
                    for (Mode mode : voxelModes)
                        sum += of(grid, 5.0, mode)[p][step];
                    return sum / static_cast<double>(std::size(voxelModes));
                });
            for (Mode mode : voxelModes)
                cells.emplace_back(
                    [&of, grid, mode](std::size_t p) { return of(grid, 5.0, mode)[p][Step::trace]; });
        }
    }
    return {measuredRow("Here", cells, processes)};
}

double rounded(double ms) {
    return std::round(ms * 1000.0) / 1000.0;
}

ordered_json roundedJson(const std::vector<double>& values) {
    ordered_json json = ordered_json::array();
    for (double value : values)
        json.push_back(rounded(value));
    return json;
}

ordered_json spreadJson(const std::vector<double>& processes) {
    return {{"mean", rounded(mean(processes))},
            {"min", rounded(*std::min_element(processes.begin(), processes.end()))},
            {"max", rounded(*std::max_element(processes.begin(), processes.end()))},
            {"processes", roundedJson(processes)}};
}

}  // namespace

std::vector<Table> measuredTables(const Measurements& measurements) {
    std::vector<Table> tables = thesisTables();
    for (Table& table : tables) {
        const std::vector<Row> rows = measuredRows(table.number, measurements);
        table.rows.insert(table.rows.begin(), rows.begin(), rows.end());
    }
    return tables;
}

ordered_json tablesJson(const std::vector<Table>& tables) {
    ordered_json json;
    for (const Table& table : tables) {
        ordered_json rows = ordered_json::array();
        for (const Row& row : table.rows) {
            const bool measured = !row.minMs.empty();
            ordered_json entry{{"platform", row.platform}, {"source", measured ? "measured" : "thesis"}};
            entry["values"] = roundedJson(row.valuesMs);
            if (measured) {
                entry["min"] = roundedJson(row.minMs);
                entry["max"] = roundedJson(row.maxMs);
            }
            rows.push_back(std::move(entry));
        }
        json[table.number] = {{"title", table.title}, {"columns", table.columns}, {"rows", std::move(rows)}};
    }
    return json;
}

ordered_json measurementsJson(const Measurements& measurements) {
    ordered_json json = ordered_json::array();
    for (const auto& [key, runs] : measurements) {
        ordered_json steps;
        std::vector<double> values(runs.size());
        for (int i = 0; i < stepCount; ++i) {
            const Step step = static_cast<Step>(i);
            std::transform(runs.begin(), runs.end(), values.begin(),
                           [&](const StepMeans& run) { return run[step]; });
            steps[stepName(step)] = spreadJson(values);
        }
        std::transform(runs.begin(), runs.end(), values.begin(),
                       [](const StepMeans& run) { return run.totalMs; });
        steps["total"] = spreadJson(values);
        json.push_back({{"grid", key.grid},
                        {"cone_angle_deg", key.coneAngleDeg},
                        {"mode", modeName(key.mode)},
                        {"steps", std::move(steps)}});
    }
    return json;
}

std::string tablesText(const std::vector<Table>& tables) {
    std::string text;
    char cell[32];
    for (const Table& table : tables) {
        text += "\nTable " + table.number + ": " + table.title + "\n";
        std::snprintf(cell, sizeof cell, "%-10s", "");
        text += cell;
        for (const std::string& column : table.columns) {
            std::snprintf(cell, sizeof cell, "%10s", column.c_str());
            text += cell;
        }
        text += "\n";
        for (const Row& row : table.rows) {
            std::snprintf(cell, sizeof cell, "%-10s", row.platform.c_str());
            text += cell;
            for (double value : row.valuesMs) {
                std::snprintf(cell, sizeof cell, "%10.2f", value);
                text += cell;
            }
            text += "\n";
        }
    }
    return text;
}

}  // namespace vct
