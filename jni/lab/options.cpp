#include "lab/options.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "core/error.h"
#include "scene/camera.h"
#include "scene/light_choice.h"

namespace vct {

namespace {

glm::dvec3 threeFromText(const std::string& option, const std::string& text) {
    std::istringstream numbers(text);
    std::vector<double> found;
    for (std::string number; std::getline(numbers, number, ',');)
        found.push_back(numberFromText(option, number));
    if (found.size() != 3) throw Error(option + ": '" + text + "' is not three numbers; write them as 1,2,3");
    return {found[0], found[1], found[2]};
}

// Converts "#rrggbb" in sRGB (IEC 61966-2-1) to linear RGB.
glm::vec3 fromSrgb(const std::string& option, const std::string& text) {
    if (text.size() != 7 || text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
        throw Error(option + ": '" + text +
                    "' is not a colour; write it as #rrggbb, with two hexadecimal digits each");
    glm::vec3 color(0.0F);
    for (int i = 0; i < 3; ++i) {
        const double coded =
            std::stoi(text.substr(static_cast<std::size_t>(1 + 2 * i), 2), nullptr, 16) / 255.0;
        color[i] =
            static_cast<float>(coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4));
    }
    return color;
}

// As setFromWords(), for text of the form "a=1,2,3,b=4".
void setFromParts(const std::string& option, std::string text, const NamedSetters& setters) {
    text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
    static const std::regex commaBeforeName(",(?=[^,]*=)");
    setFromWords(option + " " + std::regex_replace(text, commaBeforeName, " "), setters);
}

}  // namespace

void setFromWords(const std::string& text, const NamedSetters& setters) {
    std::istringstream words(text);
    std::string command;
    words >> command >> std::ws;
    // A word without a name belongs to the value before it.
    std::vector<std::string> settings;
    for (std::string word; std::getline(words, word, ' ');) {
        if (settings.empty() || word.find('=') != std::string::npos)
            settings.push_back(word);
        else
            settings.back() += " " + word;
    }
    std::set<std::string> given;
    for (std::string& setting : settings) {
        setting.erase(setting.find_last_not_of(' ') + 1);
        const std::size_t equals = setting.find('=');
        const auto setter = std::find_if(setters.begin(), setters.end(), [&](const auto& candidate) {
            return candidate.first == setting.substr(0, equals);
        });
        if (setter == setters.end() || equals == std::string::npos) {
            std::string names;
            for (const auto& [name, unused] : setters)
                names += (names.empty() ? "" : ", ") + name;
            throw Error(command + ": unknown '" + setting + "'; use name=value with one of the names " +
                        names);
        }
        if (!given.insert(setter->first).second)
            throw Error(command + ": " + setter->first + " is given more than once; give it once");
        setter->second(setting.substr(equals + 1));
    }
}

double numberFromText(const std::string& option, const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(value))
        throw Error(option + ": '" + text + "' is not a number");
    return value;
}

int wholeNumberFromText(const std::string& option, const std::string& text, int most) {
    const double value = numberFromText(option, text);
    if (value != std::floor(value) || value < 1.0 || value > most)
        throw Error(option + "=" + text + ": expected a whole number from 1 to " + std::to_string(most));
    return static_cast<int>(value);
}

glm::ivec2 sizeFromText(const std::string& text) {
    const std::size_t x = text.find('x');
    if (x == std::string::npos) throw Error("--size '" + text + "': expected WIDTHxHEIGHT, such as 400x400");
    return {wholeNumberFromText("--size", text.substr(0, x), 8192),
            wholeNumberFromText("--size", text.substr(x + 1), 8192)};
}

Camera cameraFromText(const std::string& text, const Scene& scene, double aspect) {
    if (text.find('=') == std::string::npos) return chooseCamera(scene, text, aspect);
    std::optional<glm::dvec3> eye, up;
    glm::dvec3 target(0.0);
    double fovDeg = 45.0;
    setFromParts("--camera", text,
                 {{"eye", [&](const auto& value) { eye = threeFromText("--camera: eye", value); }},
                  {"target", [&](const auto& value) { target = threeFromText("--camera: target", value); }},
                  {"fov", [&](const auto& value) { fovDeg = numberFromText("--camera: fov", value); }},
                  {"up", [&](const auto& value) { up = threeFromText("--camera: up", value); }}});
    if (!eye) throw Error("--camera '" + text + "' has no eye=X,Y,Z");
    return lookAt(*eye, target, fovDeg, up);
}

DirectionalLight lightFromText(const std::string& text, const Scene& scene) {
    if (text.empty()) return chooseLight(scene);
    // A scene without a sun gets the default one, changed by the text.
    DirectionalLight light = scene.lights.empty() ? defaultLight() : scene.lights.front();
    const auto setDirection = [&](const std::string& value) {
        const glm::dvec3 direction = threeFromText("--light: direction", value);
        if (glm::length(direction) == 0.0) throw Error("--light: direction must not be 0,0,0");
        light.directionToLight = -glm::normalize(direction);
        light.node = -1;  // an animation of the scene no longer moves it
    };
    setFromParts("--light", text,
                 {{"direction", setDirection},
                  {"color", [&](const auto& value) { light.color = threeFromText("--light: color", value); }},
                  {"intensity", [&](const auto& value) {
                       light.intensity = static_cast<float>(numberFromText("--light: intensity", value));
                   }}});
    // Scales the colour to a largest component of 1 and moves the factor into the intensity.
    const float largest = std::max({light.color.r, light.color.g, light.color.b});
    if (std::min({light.color.r, light.color.g, light.color.b}) < 0.0F || light.intensity < 0.0F)
        throw Error("--light: color and intensity must not be negative");
    if (largest > 0.0F) light.color /= largest;
    light.intensity *= largest;
    if (!(light.intensity <= 1e30F)) throw Error("--light: color times intensity must not exceed 1e30");
    return light;
}

glm::vec3 colorFromText(const std::string& option, const std::string& text) {
    static const std::pair<const char*, glm::vec3> names[] = {{"black", glm::vec3(0.0F)},
                                                              {"grey", glm::vec3(0.2F)},
                                                              {"white", glm::vec3(1.0F)},
                                                              {"blue", plainSky(defaultLight())}};
    for (const auto& [name, radiance] : names)
        if (text == name) return radiance;
    if (text.rfind('#', 0) == 0) return fromSrgb(option, text);
    char* end = nullptr;
    std::strtod(text.c_str(), &end);
    if (end == text.c_str()) {
        std::string list;
        for (const auto& [name, radiance] : names)
            list += std::string(list.empty() ? "" : ", ") + name;
        throw Error(option + ": '" + text +
                    "' is no radiance; write it as R,G,B, as one number, as #rrggbb, or as " + list);
    }
    const glm::vec3 color(*end == '\0' ? glm::dvec3(numberFromText(option, text))
                                       : threeFromText(option, text));
    if (glm::min(color.r, glm::min(color.g, color.b)) < 0.0F)
        throw Error(option + " " + text + ": radiance must not be negative");
    // The library has the same limit.
    if (!(glm::max(color.r, glm::max(color.g, color.b)) <= 1e30F))
        throw Error(option + " " + text + ": radiance must be at most 1e30");
    return color;
}

}  // namespace vct
