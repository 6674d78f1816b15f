#include "lab/timings.h"

#include <sys/utsname.h>
#ifdef __ANDROID__
#include <sys/system_properties.h>
#endif

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <thread>

#include "core/files.h"
#include "lab/table.h"
#include "vct/version.h"

namespace vct {

namespace {

using nlohmann::ordered_json;

constexpr int timingsVersion = 4;

ordered_json samplesJson(const std::vector<double>& samples) {
    return spreadJson("median", median(samples), "samples", samples);
}

// The times of each step, and of their sum in each frame.
ordered_json stepsJson(const std::array<std::vector<double>, stepCount>& stepsMs) {
    ordered_json json;
    std::vector<double> totalMs(stepsMs[0].size());
    for (int i = 0; i < stepCount; ++i) {
        json[stepName(static_cast<Step>(i))] = samplesJson(stepsMs[i]);
        std::transform(totalMs.begin(), totalMs.end(), stepsMs[i].begin(), totalMs.begin(), std::plus<>());
    }
    json["total"] = samplesJson(totalMs);
    return json;
}

// Returns how the GPU's clock was used, or why it was not. If it is wrong in one mode it is not used for any.
std::string gpuClockText(const TimingsReport& report) {
    for (const auto& [mode, times] : report.modes)
        if (const std::string reason = whyGpuTimesAreWrong(times); !reason.empty())
            return "not used: " + reason + " (" + outputName(mode) + ")";
    return "GL_EXT_disjoint_timer_query, GL_TIME_ELAPSED_EXT around each step of the same frames, "
           "milliseconds";
}

const char* skyText(const Settings& settings) {
    if (settings.environment) return "picture";
    return settings.skyRadiance == glm::vec3(0.0F) ? "dark" : "plain";
}

ordered_json settingsJson(const TimingsReport& report, const gl::Capabilities& capabilities) {
    const Settings& s = report.settings;
    return {{"preset", report.preset},
            {"grid", s.grid},
            {"cascades", s.cascades},
            {"width", s.size.x},
            {"height", s.size.y},
            {"voxelization", voxelizationName(voxelizationFor(s.voxels, capabilities))},
            {"shadow_map", s.shadowMapSize},
            {"cone_angle_deg", s.shadowConeAngleDeg},
            {"light_radius", s.lightRadius},
            {"sky", skyText(s)},
            {"ao_distance", s.aoDistance},
            {"light_frames", s.lightFrames}};
}

// /proc/cpuinfo has no processor name on Arm, but Android has properties with the name of the device.
std::string deviceName() {
#ifdef __ANDROID__
    std::string name;
    for (const char* property : {"ro.product.manufacturer", "ro.product.model", "ro.board.platform"}) {
        char value[PROP_VALUE_MAX] = "";
        if (__system_property_get(property, value) > 0)
            name += (name.empty() ? "" : " ") + std::string(value);
    }
    if (!name.empty()) return name;
#endif
    return "unknown";
}

}  // namespace

double roundedMs(double ms) {
    return std::round(ms * 1000.0) / 1000.0;
}

ordered_json roundedJson(const std::vector<double>& valuesMs) {
    ordered_json json = ordered_json::array();
    for (const double ms : valuesMs)
        json.push_back(roundedMs(ms));
    return json;
}

ordered_json spreadJson(const char* middle, double value, const char* list,
                        const std::vector<double>& valuesMs) {
    const auto [least, most] = std::minmax_element(valuesMs.begin(), valuesMs.end());
    return {{middle, roundedMs(value)},
            {"min", valuesMs.empty() ? 0.0 : roundedMs(*least)},
            {"max", valuesMs.empty() ? 0.0 : roundedMs(*most)},
            {list, roundedJson(valuesMs)}};
}

ordered_json machineJson() {
    std::string cpu = deviceName();
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.rfind("model name", 0) == 0) {
            cpu = line.substr(line.find(':') + 2);
            break;
        }
    utsname system{};
    uname(&system);
    return {{"cpu", cpu},
            {"threads", std::thread::hardware_concurrency()},
            {"system", std::string(system.sysname) + " " + system.release + " " + system.machine}};
}

ordered_json timingsJson(const TimingsReport& report, const gl::Capabilities& capabilities) {
    ordered_json json;
    json["version"] = timingsVersion;
    json["program"] = "vct " VCT_VERSION;
    json["scene"] = report.scene;
    json["triangles"] = report.triangles;
    json["driver"] = {{"backend", report.backend},
                      {"vendor", capabilities.vendor},
                      {"renderer", capabilities.renderer},
                      {"version", capabilities.version}};
    json["machine"] = machineJson();
    json["settings"] = settingsJson(report, capabilities);
    json["method"] = {{"clock", "glFinish before and after each step, CPU steady clock, milliseconds"},
                      {"warm_up_frames", warmUpFrames},
                      {"frames", report.timedFrames},
                      {"revoxelized_every_frame", report.settings.revoxelize}};
    const std::string gpuClock = gpuClockText(report);
    json["method"]["gpu_clock"] = gpuClock;
    const bool gpu = gpuClock.rfind("not used", 0) != 0;
    for (const auto& [mode, times] : report.modes) {
        json["modes"][outputName(mode)]["steps"] = stepsJson(times.stepMs);
        if (gpu) json["modes"][outputName(mode)]["gpu_steps"] = stepsJson(times.gpuMs);
    }
    json["active_voxels"] = report.activeVoxels;
    std::size_t gBufferBytes = 0;
    for (const Resource& resource : report.resources)
        if (resource.name.rfind("G-buffer ", 0) == 0) gBufferBytes += resource.bytes;
    json["g_buffer_bytes_per_pixel"] =
        gBufferBytes / (static_cast<std::size_t>(report.settings.size.x) * report.settings.size.y);
    json["resources"] = ordered_json::array();
    for (const Resource& resource : report.resources)
        json["resources"].push_back({{"name", resource.name}, {"bytes", resource.bytes}});
    return json;
}

std::string timingsTable(const std::vector<std::pair<Output, StepTimes>>& modes) {
    TableRows rows{{"milliseconds", "CS", "RT", "V", "L", "M", "I", "Tr", "Tot"}};
    for (const auto& [mode, times] : modes) {
        rows.push_back({outputName(mode)});
        const ordered_json steps = stepsJson(times.stepMs);
        for (const auto& [step, ms] : steps.items())
            rows.back().push_back(cellText("%.2f", ms.at("median")));
    }
    return markdownTable(rows);
}

void writeJson(const std::string& path, const ordered_json& json) {
    // JSON must be UTF-8, but file names need not be, so invalid bytes are replaced.
    replaceFile(path, json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace vct
