// What a bench prints and writes: the thesis's tables 5.2 to 5.5, or presets side by side (docs/timings.md).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace vct {

// Modes that share a grid and an angle also share a renderer, as they differ in nothing that it keeps.
struct BenchConfig {
    std::string name;  // for people
    std::string preset;
    std::string modes;  // as for modesFromText()
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

// What the thesis's tables need, the configuration of most of them first.
std::vector<BenchConfig> thesisConfigs();
// The tables; `all` holds every one of thesisConfigs(), each with as many runs.
BenchReport thesisReport(const std::vector<BenchRuns>& all);

// Every preset has as many runs, of the same modes; the ratios are the first one's over each other.
BenchReport comparisonReport(const std::vector<BenchRuns>& presets);

// What both reports begin with; `statistic` says what the numbers are.
nlohmann::ordered_json benchHeadJson(const std::vector<BenchRuns>& all, const std::string& statistic);
std::string benchHeadText(const std::vector<BenchRuns>& all);

}  // namespace vct
