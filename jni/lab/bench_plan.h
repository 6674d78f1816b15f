// What a bench measures, and how its files are put together: the same for the command line, which starts a
// process for each configuration, and for the app, which makes a renderer for each.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lab/bench_tables.h"

namespace vct {

// Modes that share a grid and an angle also share a process or renderer, as they differ in nothing that it
// keeps.
struct BenchConfig {
    std::string name;   // for people
    std::string modes;  // as for modesFromText()
    int grid;
    double coneAngleDeg;
};

// What the thesis's tables need, the configuration of most of them first.
const std::vector<BenchConfig>& benchConfigs();

// Adds what one run measured; `timings` is its timings.json.
void collect(const nlohmann::ordered_json& timings, const BenchConfig& config, Measurements& measurements);

// bench.json (docs/timings.md). `timings`: of any run, for what is common to all of them. `runs`: what one
// configuration is measured in, "processes" or "renderers".
nlohmann::ordered_json benchJson(const nlohmann::ordered_json& timings, const Measurements& measurements,
                                 const std::string& runs);

// The tables for people, with what was measured on what in front.
std::string benchText(const nlohmann::ordered_json& bench, const Measurements& measurements);

}  // namespace vct
