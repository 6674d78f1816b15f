#include "app/choices.h"

#include <algorithm>
#include <cmath>
#include <tuple>

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
        return std::tie(c.preset, c.mode, c.grid, c.coneAngleDeg, c.resolution, c.lightAnglesDeg,
                        c.timeSteps);
    };
    return all(*this) == all(other);
}

Settings settingsFor(const Choices& choices, glm::ivec2 window) {
    Settings settings = presetSettings(choices.preset);
    settings.mode = choices.mode;
    settings.grid = choices.grid;
    settings.shadowConeAngleDeg = choices.coneAngleDeg;
    const Resolution& resolution = resolutions().at(static_cast<std::size_t>(choices.resolution));
    settings.size =
        resolution.divisor > 0 ? glm::max(window / resolution.divisor, glm::ivec2(1)) : resolution.fixed;
    return settings;
}

DirectionalLight lightFor(const Choices& choices, const Scene& scene) {
    DirectionalLight light = chooseLight(scene);
    if (choices.lightAnglesDeg) {
        const glm::dvec2 angles = glm::radians(glm::dvec2(*choices.lightAnglesDeg));
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
