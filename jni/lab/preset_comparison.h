// Presets side by side: what each step of a frame costs, and how many times that of the first.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace vct {

// One preset's timings.json (docs/timings.md) of each process that measured it.
struct PresetRuns {
    std::string preset;
    std::vector<nlohmann::ordered_json> timings;
};

// docs/timings.md, "Presets side by side". Every preset has as many processes, and the same modes.
nlohmann::ordered_json comparisonJson(const std::vector<PresetRuns>& presets);

// Markdown: the README's table, and one for each mode that needs voxels.
std::string comparisonText(const nlohmann::ordered_json& comparison);

}  // namespace vct
