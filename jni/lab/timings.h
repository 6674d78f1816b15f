// Writes timings.json: the times of a run, the machine, the settings and the method. docs/timings.md
// describes every field. The app writes the same file.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "engine/renderer.h"
#include "engine/step_timer.h"
#include "gl/capabilities.h"

namespace vct {

// The thesis's method (5.1.2): warm-up frames, then an average over five frames.
constexpr int warmUpFrames = 2;
constexpr int timedFrames = 5;

struct TimingsReport {
    std::string scene;
    std::size_t triangles = 0;
    std::string backend;
    std::string preset;
    Settings settings;
    std::vector<std::pair<Output, StepTimes>> modes;
    int timedFrames = vct::timedFrames;  // per mode
    std::vector<std::uint32_t> activeVoxels;
    std::vector<Resource> resources;
};

nlohmann::ordered_json timingsJson(const TimingsReport& report, const gl::Capabilities& capabilities);

// Returns a table of medians in milliseconds, one row per mode. The columns are the thesis's CS (shadow map),
// RT (G-buffer), V (voxelization), M (mip levels), Tr (final shading) and Tot (total), and L (light
// injection) and I (irradiance).
std::string timingsTable(const std::vector<std::pair<Output, StepTimes>>& modes);

double roundedMs(double ms);  // rounds to a microsecond
nlohmann::ordered_json roundedJson(const std::vector<double>& valuesMs);
// Returns {`middle`: value, "min": ..., "max": ..., `list`: the values}; without values, min and max are 0.
nlohmann::ordered_json spreadJson(const char* middle, double value, const char* list,
                                  const std::vector<double>& valuesMs);

// Describes the processor, its threads and the operating system.
nlohmann::ordered_json machineJson();

// Writes a JSON file atomically (replaceFile()). Throws vct::Error.
void writeJson(const std::string& path, const nlohmann::ordered_json& json);

}  // namespace vct
