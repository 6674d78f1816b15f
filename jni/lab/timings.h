// timings.json: what a run measured, on what, and how. docs/timings.md describes every field; the phone
// writes the same.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "engine/renderer.h"
#include "engine/step_timer.h"
#include "gl/capabilities.h"

namespace vct {

// The thesis's method: some frames to warm up, then an average over five (5.1.2).
constexpr int warmUpFrames = 2;
constexpr int timedFrames = 5;

struct TimingsReport {
    std::string scene;
    std::size_t triangles = 0;
    std::string backend;
    std::string preset;
    Settings settings;
    std::vector<std::pair<Output, StepTimes>> modes;
    int timedFrames = vct::timedFrames;  // of each mode
    std::vector<std::uint32_t> activeVoxels;
    std::vector<Resource> resources;
};

nlohmann::ordered_json timingsJson(const TimingsReport& report, const gl::Capabilities& capabilities);

// One row per mode, the thesis's columns CS, RT, V, M, Tr, Tot with I, the irradiance, medians in
// milliseconds.
std::string timingsTable(const std::vector<std::pair<Output, StepTimes>>& modes);

double roundedMs(double ms);  // to a microsecond
nlohmann::ordered_json roundedJson(const std::vector<double>& valuesMs);
// {`middle`: value, "min", "max", `list`: the values}; zeros where there are none.
nlohmann::ordered_json spreadJson(const char* middle, double value, const char* list,
                                  const std::vector<double>& valuesMs);

// Processor, its threads and the system, for people.
nlohmann::ordered_json machineJson();

// Written beside the target and then renamed; throws vct::Error.
void writeJson(const std::string& path, const nlohmann::ordered_json& json);

}  // namespace vct
