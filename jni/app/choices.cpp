#include "app/choices.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/error.h"
#include "engine/grid_choice.h"
#include "lab/options.h"
#include "scene/light_choice.h"

namespace vct::app {

namespace {
const Resolution& resolutionOf(const Choices& choices) {
    return resolutions().at(static_cast<std::size_t>(choices.resolution));
}
}  // namespace

const std::vector<Resolution>& resolutions() {
    static const std::vector<Resolution> all{
        {"automatic", "auto", 0, {}},      {"size of the window", "1", 1, {}},
        {"1/2 of the window", "2", 2, {}}, {"1/3 of the window", "3", 3, {}},
        {"1/4 of the window", "4", 4, {}}, {"400x400, as in the thesis", "thesis", 0, {400, 400}}};
    return all;
}

const std::vector<Sky>& skies() {
    static const std::vector<Sky> all{Sky::scene, Sky::dark, Sky::plain};
    return all;
}

const char* skyName(Sky sky) {
    return sky == Sky::scene ? "scene" : sky == Sky::dark ? "dark" : sky == Sky::plain ? "plain" : "picture";
}

ShowRequest showRequestFromText(const std::string& text) {
    ShowRequest request;
    Choices& choices = request.choices;
    std::optional<int> grid, cascades;  // replace the preset's, in whatever order they are given
    const auto setSwitch = [](const char* name, bool& on) {
        return [name, &on](const std::string& value) {
            if (value != "on" && value != "off")
                throw Error(std::string("show: ") + name + "='" + value + "' is not valid; use on or off");
            on = value == "on";
        };
    };
    const auto setPixels = [&](const std::string& value) {
        const auto found =
            std::find_if(resolutions().begin(), resolutions().end(),
                         [&](const Resolution& resolution) { return value == resolution.word; });
        if (found == resolutions().end())
            throw Error("show: pixels='" + value + "' is not valid; use auto, 1, 2, 3, 4 or thesis");
        choices.resolution = static_cast<int>(found - resolutions().begin());
    };
    const auto setTime = [&](const std::string& value) {
        request.timeS = numberFromText("show: time", value);
        if (request.timeS < 0.0)
            throw Error("show: time='" + value + "' is not valid; use a number of seconds of 0 or more");
        choices.play = false;
    };
    const auto setSky = [&](const std::string& value) {
        const auto found =
            std::find_if(skies().begin(), skies().end(), [&](Sky sky) { return value == skyName(sky); });
        if (found == skies().end() && value.find(".hdr") == std::string::npos)
            throw Error("show: sky='" + value +
                        "' is not valid; use scene, dark, plain or the name of a .hdr file");
        choices.sky = found == skies().end() ? Sky::picture : *found;
        if (found == skies().end()) choices.skyPicture = value;
    };
    const auto setLightsOff = [&](const std::string& value) {
        std::istringstream numbers(value);
        for (std::string number; std::getline(numbers, number, ',');)
            choices.lightsOff.set(static_cast<std::size_t>(
                wholeNumberFromText("show: lights-off", number, VCT_MAX_PUNCTUAL_LIGHTS) - 1));
    };
    setFromWords(
        text,
        {{"scene", [&](const auto& value) { request.scene = value; }},
         {"preset", [&](const auto& value) { choosePreset(choices, value); }},
         {"mode", [&](const auto& value) { choices.mode = modesFromText(value).front(); }},
         {"grid", [&](const auto& value) { grid = wholeNumberFromText("show: grid", value, 100000); }},
         {"cascades",
          [&](const auto& value) {
              if (value != "auto") cascades = wholeNumberFromText("show: cascades", value, VCT_MAX_CASCADES);
          }},
         {"cone-angle",
          [&](const auto& value) {
              choices.coneAngleDeg = static_cast<float>(numberFromText("show: cone-angle", value));
          }},
         {"pixels", setPixels},
         {"display", setSwitch("display", request.display)},
         {"steps", setSwitch("steps", choices.timeSteps)},
         {"revoxelize", setSwitch("revoxelize", choices.revoxelize)},
         {"sky", setSky},
         {"lights-off", setLightsOff},
         {"record",
          [&](const auto& value) { request.recordS = wholeNumberFromText("show: record", value, 3600); }},
         {"time", setTime}});
    if (grid) request.choices.grid = *grid;
    choices.cascades = cascades;
    validate(settingsFor(request.choices, glm::ivec2(1), 1.0));
    return request;
}

void choosePreset(Choices& choices, const std::string& name) {
    choices.grid = presetSettings(name).grid;
    choices.cascades.reset();
    choices.preset = name;
}

int cascadesFor(const Scene& scene, const Settings& settings) {
    constexpr double largestVoxel = 0.25;  // metres
    return cascadesForVoxelSize(scene.boundsWorld, settings, largestVoxel);
}

bool scaleFollowsTime(const Choices& choices) {
    return resolutionOf(choices).divisor == 0 && resolutionOf(choices).fixed == glm::ivec2(0);
}

Settings settingsFor(const Choices& choices, glm::ivec2 window, double divisor) {
    Settings settings = presetSettings(choices.preset);
    settings.grid = choices.grid;
    settings.cascades = choices.cascades.value_or(1);
    settings.shadowConeAngleDeg = choices.coneAngleDeg;
    settings.revoxelize = choices.revoxelize;
    const Resolution& resolution = resolutionOf(choices);
    if (resolution.divisor > 0) divisor = resolution.divisor;
    settings.size = resolution.fixed == glm::ivec2(0)
                        ? glm::max(glm::ivec2(glm::dvec2(window) / divisor), glm::ivec2(1))
                        : resolution.fixed;
    return settings;
}

glm::vec3 skyRadianceFor(const Choices& choices, const glm::vec3& sceneSky, const DirectionalLight& light) {
    if (choices.sky == Sky::scene || choices.sky == Sky::picture) return sceneSky;
    return choices.sky == Sky::plain ? plainSky(light) : glm::vec3(0.0F);
}

DirectionalLight lightFor(const Choices& choices, DirectionalLight light) {
    if (choices.lightAnglesDeg) {
        const glm::dvec2 angles = glm::radians(glm::dvec2(*choices.lightAnglesDeg));
        light.node = -1;  // an animation of the scene no longer moves it
        light.directionToLight = {std::cos(angles.y) * std::sin(angles.x), std::sin(angles.y),
                                  std::cos(angles.y) * std::cos(angles.x)};
    }
    return light;
}

glm::vec2 lightAnglesDeg(const DirectionalLight& light) {
    const glm::dvec3& l = light.directionToLight;
    return glm::degrees(glm::dvec2(std::atan2(l.x, l.z), std::asin(std::clamp(l.y, -1.0, 1.0))));
}

}  // namespace vct::app
