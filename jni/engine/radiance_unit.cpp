#include "engine/radiance_unit.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>

#include "engine/environment.h"

namespace vct {
namespace {

// Half of what half floats can store is left for light that is added up.
constexpr float largestStored = 3e4F;
// Below this, light of a thousandth of the brightest would have less than six bits.
constexpr float smallestStored = 0.01F;

float largestOf(const glm::vec3& color) {
    return std::max({color.r, color.g, color.b});
}

// The radiance of a white surface near a light. A point or spot light is assumed to be at least this share of
// the scene's diagonal away from all surfaces.
constexpr double nearestShare = 0.02;
float radianceNear(const PunctualLight& light, double diagonal) {
    const double distance = light.type == PunctualLight::Type::directional ? 1.0 : nearestShare * diagonal;
    return static_cast<float>(light.intensity * double{largestOf(light.color)} /
                              (distance * distance * glm::pi<double>()));
}

float largestRadiance(const Scene& scene, const Settings& settings) {
    float largest = largestOf(settings.skyRadiance);
    if (settings.environment) largest = std::max(largest, settings.environment->largestRadiance());
    for (const Material& material : scene.materials)
        largest = std::max(largest, largestOf(material.emissive));
    const double diagonal = std::max(glm::length(scene.boundsWorld.max - scene.boundsWorld.min), 1e-9);
    for (const PunctualLight& light : scene.punctualLights)
        largest = std::max(largest, radianceNear(light, diagonal));
    return largest;
}

}  // namespace

float sunlitRadiance(const DirectionalLight& light) {
    return light.intensity > 0.0F ? light.intensity / glm::pi<float>() : 0.0F;
}

float radianceUnit(const Scene& scene, const DirectionalLight& light, const Settings& settings) {
    const float sunlit = sunlitRadiance(light), largest = largestRadiance(scene, settings);
    const float usual = sunlit > 0.0F ? sunlit : largest > 0.0F && largest < smallestStored ? largest : 1.0F;
    return std::max(usual, largest / largestStored);
}

}  // namespace vct
