#include "scene/light_choice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "scene/first_surfaces.h"
#include "scene/framing.h"
#include "scene/scene_features.h"

namespace vct {
namespace {

constexpr double pi = 3.14159265358979323846;
// Smallest share of all directions in which a room without windows has a surface. Cracks between its walls do
// not count.
constexpr double sealedShare = 0.99;
constexpr int roomResolution = 16;

// The space that is visible from a point.
struct Space {
    double closed = 0.0;     // share of all directions that have a surface
    double solid = 0.0;      // share of all directions whose first side is a back
    double volume = 0.0;     // cubic metres
    glm::dvec3 middle{0.0};  // centre of mass
    double ceiling = 0.0;    // distance of the first surface above the point

    bool isSealed() const { return closed >= sealedShare; }
    bool isRoom() const { return isSealed() && solid < 0.5; }
};

Space spaceAround(const Scene& scene, const glm::dvec3& point) {
    std::vector<FirstSurfaces> views = viewsAround(point, roomResolution);
    for (FirstSurfaces& view : views)
        view.findsBacks = true;
    drawFirstSurfaces(scene, views);
    Space space;
    double steepest = 0.0;
    for (const FirstSurfaces& view : views) {
        for (std::size_t i = 0; i < view.samples.size(); ++i) {
            const FirstSurfaces::Sample& sample = view.samples[i];
            const bool back = sample.backDepth > 0.0 &&
                              (sample.depth == 0.0 || sample.backDepth < (1.0 + 1e-6) * sample.depth);
            const double depth = back ? sample.backDepth : sample.depth;
            if (depth == 0.0) continue;
            const double share = view.solidAngle(i) / (4.0 * pi);
            const glm::dvec3 way = depth * view.direction(i);
            const double distance = glm::length(way);
            space.closed += share;
            if (back) space.solid += share;
            const double volume = share * 4.0 / 3.0 * pi * distance * distance * distance;
            space.volume += volume;
            space.middle += volume * (point + 0.75 * way);
            if (way.y <= steepest * distance) continue;
            steepest = way.y / distance;
            space.ceiling = distance;
        }
    }
    space.middle /= space.volume;
    return space;
}

// A point in the closed room that a camera shows. Light does not pass the back of a wall that
// the camera looks through.
std::optional<glm::dvec3> pointInRoom(const Scene& scene, const Camera& camera) {
    const glm::dvec3 eye(camera.worldFromCamera[3]);
    std::vector<FirstSurfaces> ahead{{eye, glm::dmat3(camera.worldFromCamera), 1e-3, 1e-3, 1}};
    drawFirstSurfaces(scene, ahead);
    const glm::dvec3 way = ahead.front().samples.front().depth * ahead.front().direction(0);
    for (const double share : {0.0, 0.95, 0.75, 0.5, 0.25})
        if (spaceAround(scene, eye + share * way).isRoom()) return eye + share * way;
    return {};
}

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

std::optional<PunctualLight> chooseRoomLight(const Scene& scene, const Camera& camera) {
    if (!scene.lights.empty() || !scene.punctualLights.empty()) return {};
    const std::optional<glm::dvec3> inRoom = pointInRoom(scene, camera);
    if (!inRoom || isLitByEmitters(scene)) return {};
    glm::dvec3 place = *inRoom;
    Space space = spaceAround(scene, place);
    const auto moveTo = [&](const glm::dvec3& point) {
        const Space there = spaceAround(scene, point);
        if (!there.isRoom()) return;  // something is there
        place = point;
        space = there;
    };
    // A window may look narrow from beside it.
    if (!spaceAround(scene, space.middle).isSealed()) return {};
    moveTo(space.middle);
    moveTo(place + glm::dvec3(0.0, 0.6 * space.ceiling, 0.0));
    const double radius = std::cbrt(space.volume / (4.0 / 3.0 * pi));
    PunctualLight light;
    light.name = "light";
    light.worldFromLight[3] = glm::dvec4(place, 1.0);
    light.intensity = static_cast<float>(std::clamp(pi * radius * radius, 1e-30, 1e30));
    return light;
}

std::string roomLightNote(const PunctualLight& light) {
    const glm::dvec4& place = light.worldFromLight[3];
    char text[200];
    std::snprintf(
        text, sizeof text,
        "note: the picture shows a closed room without a light; vct adds a point light of %.3g cd at "
        "%.4g,%.4g,%.4g",
        double{light.intensity}, place.x, place.y, place.z);
    return text;
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
