#include "lab/bench_report.h"

#include <sstream>

namespace vct {

using nlohmann::ordered_json;

const ordered_json* stepsOf(const ordered_json& timings, const std::string& mode) {
    if (timings.contains("mode")) return timings.at("mode") == mode ? &timings.at("steps") : nullptr;
    return timings.at("modes").contains(mode) ? &timings.at("modes").at(mode).at("steps") : nullptr;
}

ordered_json benchHeadJson(const std::vector<BenchRuns>& all, const std::string& statistic) {
    const ordered_json& first = all.front().timings.front();
    ordered_json json{{"version", 1}};
    for (const char* key : {"program", "scene", "triangles", "driver", "machine", "method"})
        json[key] = first.at(key);
    json["method"]["fresh"] = "renderers";
    json["method"]["processes"] = all.front().timings.size();
    json["method"]["statistic"] = statistic;
    return json;
}

std::string benchHeadText(const std::vector<BenchRuns>& all) {
    const ordered_json& first = all.front().timings.front();
    const ordered_json& settings = first.at("settings");
    std::ostringstream text;
    text << first.at("scene").get<std::string>() << ", " << first.at("triangles") << " triangles, "
         << settings.at("width") << "x" << settings.at("height") << " pixels, shadow map "
         << settings.at("shadow_map") << "\nHere: " << first.at("driver").at("renderer").get<std::string>()
         << ", " << first.at("driver").at("version").get<std::string>() << "; "
         << first.at("machine").at("cpu").get<std::string>() << ", " << first.at("machine").at("threads")
         << " threads\nMilliseconds; each number is of " << all.front().timings.size()
         << " renderers, made one after the other, of " << first.at("method").at("frames")
         << " frames each\n";
    return text.str();
}

}  // namespace vct
