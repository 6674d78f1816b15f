// The thesis's tables 5.2 to 5.5: what it printed, and the same measured here.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/settings.h"
#include "lab/step_timer.h"

namespace vct {

// What a measurement depends on in those tables.
struct BenchCase {
    int grid;
    double coneAngleDeg;
    Mode mode;
    auto operator<=>(const BenchCase&) const = default;
};

// Of one process: each step's average over its frames.
struct StepMeans {
    std::array<double, stepCount> stepMs;
    double totalMs;

    double operator[](Step step) const { return stepMs[static_cast<std::size_t>(step)]; }
    // The thesis's (*): a static scene, voxelized once and not in every frame.
    double withoutVoxelizingMs() const {
        return totalMs - (*this)[Step::voxelize] - (*this)[Step::mipmap] - (*this)[Step::irradiance];
    }
};

// Of every process, in the order in which they ran.
using Measurements = std::map<BenchCase, std::vector<StepMeans>>;

struct Row {
    std::string platform;
    std::vector<double> valuesMs;
    // Of the processes; empty for what the thesis printed.
    std::vector<double> minMs, maxMs;
};

struct Table {
    std::string number;  // as in the thesis, "5.2"
    std::string title;
    std::vector<std::string> columns;
    std::vector<Row> rows;
};

// As printed (chapter 5.1).
std::vector<Table> thesisTables();

// The same with the rows measured here in front.
std::vector<Table> measuredTables(const Measurements& measurements);

nlohmann::ordered_json tablesJson(const std::vector<Table>& tables);
nlohmann::ordered_json measurementsJson(const Measurements& measurements);
std::string tablesText(const std::vector<Table>& tables);

}  // namespace vct
