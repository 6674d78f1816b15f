#include "lab/options.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <vector>

#include "core/error.h"
#include "scene/camera.h"

namespace vct {

namespace {

// "a=1,2,3,b=4" -> {a: {1, 2, 3}, b: {4}}.
std::map<std::string, std::vector<double>> keyedNumbers(const std::string& option, const std::string& text) {
    std::map<std::string, std::vector<double>> values;
    std::istringstream parts(text);
    std::string part, key;
    while (std::getline(parts, part, ',')) {
        const std::size_t equals = part.find('=');
        if (equals != std::string::npos) {
            key = part.substr(0, equals);
            part = part.substr(equals + 1);
        }
        if (key.empty()) throw Error(option + " '" + text + "': expected name=value, see --help");
        values[key].push_back(numberFromText(option, part));
    }
    return values;
}

glm::dvec3 three(const std::string& option, const std::string& key, const std::vector<double>& values) {
    if (values.size() != 3) throw Error(option + ": " + key + " takes three numbers, X,Y,Z");
    return {values[0], values[1], values[2]};
}

double one(const std::string& option, const std::string& key, const std::vector<double>& values) {
    if (values.size() != 1) throw Error(option + ": " + key + " takes one number");
    return values[0];
}

}  // namespace

void setFromWords(const std::string& text, const NamedSetters& setters) {
    std::istringstream words(text);
    std::string command, word;
    words >> command;
    while (words >> word) {
        const std::size_t equals = word.find('=');
        const auto setter = std::find_if(setters.begin(), setters.end(), [&](const auto& candidate) {
            return candidate.first == word.substr(0, equals);
        });
        if (setter == setters.end() || equals == std::string::npos) {
            std::string names;
            for (const auto& [name, unused] : setters)
                names += (names.empty() ? "" : ", ") + name;
            throw Error(command + ": unknown '" + word + "'; there are " + names + ", each as name=value");
        }
        setter->second(word.substr(equals + 1));
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

Camera cameraFromText(const std::string& text, const Scene& scene) {
    if (text.find('=') == std::string::npos) return chooseCamera(scene, text);
    glm::dvec3 eye(0.0);
    glm::dvec3 target(0.0);
    double fovDeg = 45.0;
    bool hasEye = false;
    for (const auto& [key, values] : keyedNumbers("--camera", text)) {
        if (key == "eye") {
            eye = three("--camera", key, values);
            hasEye = true;
        } else if (key == "target") {
            target = three("--camera", key, values);
        } else if (key == "fov") {
            fovDeg = one("--camera", key, values);
        } else {
            throw Error("--camera: unknown part '" + key + "'; there are eye, target, fov");
        }
    }
    if (!hasEye) throw Error("--camera '" + text + "' has no eye=X,Y,Z");
    return lookAt(eye, target, fovDeg);
}

DirectionalLight lightFromText(const std::string& text, const Scene& scene) {
    DirectionalLight light = chooseLight(scene);
    if (text.empty()) return light;
    for (const auto& [key, values] : keyedNumbers("--light", text)) {
        if (key == "direction") {
            const glm::dvec3 direction = three("--light", key, values);
            if (glm::length(direction) == 0.0) throw Error("--light: direction must not be 0,0,0");
            light.towardsLight = -glm::normalize(direction);
            light.node = -1;  // stays there
        } else if (key == "color") {
            light.color = glm::vec3(three("--light", key, values));
        } else if (key == "intensity") {
            light.intensity = static_cast<float>(one("--light", key, values));
        } else {
            throw Error("--light: unknown part '" + key + "'; there are direction, color, intensity");
        }
    }
    // The largest component of the colour is 1: the rest is intensity.
    const float largest = std::max({light.color.r, light.color.g, light.color.b});
    if (std::min({light.color.r, light.color.g, light.color.b}) < 0.0F || light.intensity < 0.0F)
        throw Error("--light: color and intensity must not be negative");
    if (largest > 0.0F) light.color /= largest;
    light.intensity *= largest;
    if (!(light.intensity <= 1e30F)) throw Error("--light: color times intensity must not be beyond 1e30");
    return light;
}

glm::vec3 colorFromText(const std::string& option, const std::string& text) {
    const auto values = keyedNumbers(option, "color=" + text);
    const glm::vec3 color(three(option, "color", values.at("color")));
    if (glm::min(color.r, glm::min(color.g, color.b)) < 0.0F)
        throw Error(option + " " + text + ": radiance must not be negative");
    return color;
}

}  // namespace vct
