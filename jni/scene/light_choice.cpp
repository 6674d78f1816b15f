#include "scene/light_choice.h"

#include <algorithm>

#include "scene/framing.h"
#include "scene/scene_features.h"

namespace vct {
namespace {

constexpr double pi = 3.14159265358979323846;

}  // namespace

bool isLitByEmitters(const Scene& scene) {
    if (!scene.lights.empty() || !scene.punctualLights.empty()) return false;
    const std::vector<unsigned> materials = featuresOf(scene).materialFeatures;
    return std::any_of(materials.begin(), materials.end(),
                       [](unsigned features) {
                           return (features & featureEmissive) != 0 &&
                                  (features & featureEmissiveTexture) == 0;
                       }) &&
           isOpenRoom(scene);
}

DirectionalLight chooseLight(const Scene& scene) {
    if (!scene.lights.empty()) return scene.lights.front();
    DirectionalLight light = defaultLight();
    if (scene.punctualLights.empty()) {
        if (isLitByEmitters(scene)) light.intensity = 0.0F;
        return light;
    }
    const glm::dvec3 size = scene.boundsWorld.max - scene.boundsWorld.min;
    const double distance = std::max(0.25 * std::max({size.x, size.y, size.z}), 1e-15);
    double strongest = 0.0;  // lux
    for (const PunctualLight& other : scene.punctualLights) {
        const bool placed = other.type != PunctualLight::Type::directional;
        strongest = std::max(strongest, other.intensity / (placed ? distance * distance : 1.0));
    }
    light.color = glm::vec3(0.0F);
    light.intensity = static_cast<float>(std::min(strongest, 1e30));
    return light;
}

DirectionalLight defaultLight() {
    DirectionalLight light;
    light.directionToLight = glm::normalize(glm::dvec3(0.5, 1.0, 0.75));
    light.intensity = static_cast<float>(pi);
    return light;
}

glm::vec3 chooseSky(const Scene& scene) {
    const bool isLit = !scene.lights.empty() || !scene.punctualLights.empty() || isLitByEmitters(scene);
    return isLit ? glm::vec3(0.0F) : plainSky(defaultLight());
}

glm::vec3 plainSky(const DirectionalLight& light) {
    const float lux = light.intensity > 0.0F ? light.intensity : defaultLight().intensity;
    return glm::vec3(0.2F, 0.25F, 0.35F) * static_cast<float>(lux / pi);
}

}  // namespace vct
