// Punctual lights made in code, and their closed forms (KHR_lights_punctual).
#pragma once

#include <glm/gtc/matrix_transform.hpp>

#include "scene/scene.h"
#include "support/scenes.h"

namespace vct::test {

// E of a sun of intensity pi. Pictures without a sun are relative to it.
constexpr double unitLux = pi;

// A light at `place` towards `target`.
inline PunctualLight punctualLightAt(PunctualLight::Type type, const glm::dvec3& place,
                                     const glm::dvec3& target) {
    PunctualLight light;
    light.type = type;
    const glm::dvec3 up =
        std::abs(glm::normalize(target - place).y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    light.worldFromLight = glm::inverse(glm::lookAt(place, target, up));
    light.intensity = 4.0F;
    light.color = {1.0F, 0.5F, 0.25F};
    return light;
}

// A sun without light, with E = unitLux.
inline DirectionalLight darkSun() {
    DirectionalLight dark = lightFrom({0, 1, 0});
    dark.color = glm::vec3(0.0F);
    return dark;
}

// Irradiance over unitLux of a surface that sees the light: the extension's formulas.
inline double irradianceOf(const PunctualLight& light, const glm::dvec3& position, const glm::dvec3& normal) {
    const glm::dvec3 axis = -glm::dvec3(light.worldFromLight[2]);
    if (light.type == PunctualLight::Type::directional)
        return light.intensity * std::max(glm::dot(normal, -axis), 0.0) / unitLux;
    const glm::dvec3 offset = glm::dvec3(light.worldFromLight[3]) - position;
    const double distance = glm::length(offset);
    const double cosine = std::max(glm::dot(normal, offset / distance), 0.0);
    double share = std::clamp(1.0 - std::pow(distance / light.range, 4.0), 0.0, 1.0);
    if (light.type == PunctualLight::Type::spot) {
        const double outer = std::cos(light.outerConeRad), inner = std::cos(light.innerConeRad);
        const double cone =
            std::clamp((glm::dot(-offset / distance, axis) - outer) / (inner - outer), 0.0, 1.0);
        share *= cone * cone;
    }
    return share * light.intensity * cosine / (distance * distance) / unitLux;
}

}  // namespace vct::test
