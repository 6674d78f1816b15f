// Reports of a benchmark: the thesis's tables 5.2 to 5.5, or a comparison of presets (docs/timings.md).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace vct {

// One configuration to measure. All of its modes are rendered by the same renderer.
struct BenchConfig {
    std::string name;  // in messages
    std::string preset;
    std::string modes;  // text for modesFromText()
    int grid;
    double coneAngleDeg;
};

struct BenchRuns {
    BenchConfig config;
    std::vector<nlohmann::ordered_json> timings;  // the timings.json of each run
};

struct BenchReport {
    nlohmann::ordered_json json;
    std::string text;
};

// The configurations that the thesis's tables need. The first one is that of most tables.
std::vector<BenchConfig> thesisConfigs();
// Returns the tables. `all` has all of thesisConfigs(), with the same number of runs each.
BenchReport thesisReport(const std::vector<BenchRuns>& all);

// Compares presets, which have the same number of runs and the same modes. A ratio is the first preset's time
// over that of another.
BenchReport comparisonReport(const std::vector<BenchRuns>& presets);

// The beginning of both reports. `statistic` describes the numbers.
nlohmann::ordered_json benchHeadJson(const std::vector<BenchRuns>& all, const std::string& statistic);
std::string benchHeadText(const std::vector<BenchRuns>& all);

}  // namespace vct
