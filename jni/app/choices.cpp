#include "app/choices.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <tuple>

#include "core/error.h"
#include "scene/camera.h"

namespace vct::app {

const std::vector<Resolution>& resolutions() {
    static const std::vector<Resolution> all{{"as the window", 1, {}},
                                             {"1/2 of the window", 2, {}},
                                             {"1/3 of the window", 3, {}},
                                             {"1/4 of the window", 4, {}},
                                             {"400x400, as the thesis", 0, {400, 400}}};
    return all;
}

bool Choices::operator==(const Choices& other) const {
    const auto all = [](const Choices& c) {
        return std::tie(c.preset, c.mode, c.grid, c.coneAngleDeg, c.resolution, c.lightAnglesDeg, c.timeSteps,
                        c.play, c.revoxelize);
    };
    return all(*this) == all(other);
}

ShowRequest showRequestFromText(const std::string& text) {
    ShowRequest request;
    const auto onOff = [](const std::string& key, const std::string& value) {
        if (value != "on" && value != "off")
            throw Error("show: " + key + " is on or off, not '" + value + "'");
        return value == "on";
    };
    std::istringstream words(text);
    std::string word;
    words >> word;
    std::optional<int> grid;  // over the preset's, in whichever order they stand
    while (words >> word) {
        const std::size_t equals = word.find('=');
        const std::string key = word.substr(0, equals);
        const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
        Choices& choices = request.choices;
        if (key == "scene") {
            request.scene = value;
        } else if (key == "preset") {
            choosePreset(choices, value);
        } else if (key == "mode") {
            choices.mode = modesFromText(value).front();
        } else if (key == "grid") {
            grid = std::atoi(value.c_str());
        } else if (key == "cone-angle") {
            choices.coneAngleDeg = std::strtof(value.c_str(), nullptr);
        } else if (key == "pixels") {
            const int divisor = value == "thesis" ? 0 : std::atoi(value.c_str());
            const auto found = std::find_if(resolutions().begin(), resolutions().end(),
                                            [&](const Resolution& r) { return r.divisor == divisor; });
            if (found == resolutions().end() || (divisor == 0 && value != "thesis"))
                throw Error("show: pixels is 1, 2, 3, 4 or thesis, not '" + value + "'");
            choices.resolution = static_cast<int>(found - resolutions().begin());
        } else if (key == "display") {
            request.display = onOff(key, value);
        } else if (key == "steps") {
            choices.timeSteps = onOff(key, value);
        } else if (key == "revoxelize") {
            choices.revoxelize = onOff(key, value);
        } else if (key == "time") {
            char* end = nullptr;
            request.timeS = std::strtod(value.c_str(), &end);
            if (value.empty() || *end != '\0' || !std::isfinite(request.timeS) || request.timeS < 0.0)
                throw Error("show: time is a number of seconds from 0 on, not '" + value + "'");
            choices.play = false;
        } else {
            throw Error(
                "show: unknown '" + word +
                "'; there are scene, preset, mode, grid, cone-angle, pixels, display, steps, revoxelize and "
                "time, each as name=value");
        }
    }
    if (grid) request.choices.grid = *grid;
    validate(settingsFor(request.choices, glm::ivec2(1)));
    return request;
}

void choosePreset(Choices& choices, const std::string& name) {
    choices.grid = presetSettings(name).grid;
    choices.preset = name;
}

Settings settingsFor(const Choices& choices, glm::ivec2 window) {
    Settings settings = presetSettings(choices.preset);
    settings.grid = choices.grid;
    settings.shadowConeAngleDeg = choices.coneAngleDeg;
    settings.revoxelize = choices.revoxelize;
    const Resolution& resolution = resolutions().at(static_cast<std::size_t>(choices.resolution));
    settings.size =
        resolution.divisor > 0 ? glm::max(window / resolution.divisor, glm::ivec2(1)) : resolution.fixed;
    return settings;
}

DirectionalLight lightFor(const Choices& choices, const Scene& scene) {
    DirectionalLight light = chooseLight(scene);
    if (choices.lightAnglesDeg) {
        const glm::dvec2 angles = glm::radians(glm::dvec2(*choices.lightAnglesDeg));
        light.node = -1;  // stays there
        light.towardsLight = {std::cos(angles.y) * std::sin(angles.x), std::sin(angles.y),
                              std::cos(angles.y) * std::cos(angles.x)};
    }
    return light;
}

glm::vec2 lightAnglesDeg(const DirectionalLight& light) {
    const glm::dvec3& l = light.towardsLight;
    return glm::degrees(glm::dvec2(std::atan2(l.x, l.z), std::asin(std::clamp(l.y, -1.0, 1.0))));
}

}  // namespace vct::app
