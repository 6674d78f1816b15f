#include "scene/light_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "scene/first_surfaces.h"
#include "scene/framing.h"
#include "scene/scene_features.h"
#include "scene/subject.h"

namespace vct {
namespace {

constexpr double pi = 3.14159265358979323846;
// Smallest share of all directions in which a room without windows has a surface. Cracks between its walls do
// not count.
constexpr double sealedShare = 0.99;
constexpr int roomResolution = 16;
// The light of a studio: a weaker sun than in the open, and a soft white sky of this radiance per lux of it,
// so that a floor has two fifths of its light from the sky.
constexpr float studioSun = 0.75F;
constexpr float studioSkyPerLux = 0.16F;
constexpr const char* roomLightName = "room light of vct";

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

Space spaceAround(const TriangleTree& tree, const glm::dvec3& point) {
    Space space;
    double steepest = 0.0;
    for (const FirstSurfaces& view : viewsAround(tree, point, roomResolution)) {
        for (std::size_t i = 0; i < view.samples.size(); ++i) {
            const FirstSurface& sample = view.samples[i];
            const bool back = sample.backDistance > 0.0;
            const double depth = back ? sample.backDistance : sample.distance;
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

// A point in the closed room that a camera is in, or whose inside it shows through the back of a wall. Such a
// back is invisible, but stops light.
std::optional<glm::dvec3> pointInRoom(const TriangleTree& tree, const Camera& camera) {
    const glm::dvec3 eye(camera.worldFromCamera[3]), ahead(-camera.worldFromCamera[2]);
    const glm::dvec3 way = tree.first(eye, ahead).distance * ahead;
    for (const double share : {0.0, 0.95})
        if (spaceAround(tree, eye + share * way).isRoom()) return eye + share * way;
    return {};
}

// Shares of the sky's radiance that a background may have, the best one first.
constexpr std::array<float, 3> backgroundShares{1.0F, 0.1F, 0.3F}, studioBackgroundShares{1.0F, 0.3F, 0.1F};
constexpr float dimShare = 0.2F;
// Shares of a picture's edge that show the background, for a camera among the scene's objects and for one
// outside, which may be near an object.
constexpr double minOpenEdgeInside = 0.7, minOpenEdgeOutside = 0.05;
// A surface in the shade shows this part of the sky's radiance, times its albedo.
constexpr float leastShade = 0.5F, mostShade = 1.8F;

// Illuminance of a surface that faces the light, in its strongest colour: a file may have the strength there.
float illuminanceOf(const DirectionalLight& light) {
    return light.intensity * std::max({light.color.r, light.color.g, light.color.b});
}

float luminanceOf(const glm::vec3& color) {
    return glm::dot(color, glm::vec3(0.2126F, 0.7152F, 0.0722F));  // IEC 61966-2-1
}

// Luminance of a material's mean albedo.
float albedoOf(const Scene& scene, const Material& material) {
    const float factor = luminanceOf(glm::vec3(material.baseColor));
    if (material.baseColorTexture < 0) return factor;
    const Texture& texture = scene.textures[static_cast<std::size_t>(material.baseColorTexture)];
    double sum = 0.0;
    std::size_t count = 0;
    const std::size_t step = 4 * std::max<std::size_t>(texture.rgba.size() / 4 / 1024, 1);
    for (std::size_t i = 0; i + 2 < texture.rgba.size(); i += step, ++count)
        sum += luminanceOf(
            glm::pow(glm::vec3(texture.rgba[i], texture.rgba[i + 1], texture.rgba[i + 2]) / 255.0F,
                     glm::vec3(2.2F)));  // about sRGB
    return count > 0 ? factor * static_cast<float>(sum / static_cast<double>(count)) : factor;
}

// The albedos of the surfaces that border on the background in a picture, one per sample there. None if
// little of the picture's edge shows the background: the sky that a yard or a window shows is the scene's.
std::vector<float> albedosAtBackground(const Scene& scene, const Camera& camera, double aspect) {
    constexpr int resolution = 96;
    const double tanHalf = std::tan(0.5 * camera.verticalFovRad);
    const FirstSurfaces view(TriangleTree(scene), glm::dvec3(camera.worldFromCamera[3]),
                             glm::dmat3(camera.worldFromCamera), aspect * tanHalf, tanHalf, resolution);
    std::vector<float> perMaterial;
    for (const Material& material : scene.materials)
        perMaterial.push_back(albedoOf(scene, material));
    std::vector<float> albedos;
    const auto instanceAt = [&](int x, int y) {
        return view.samples[static_cast<std::size_t>(y) * resolution + x].instance;
    };
    int open = 0;  // samples of the edge
    for (int i = 0; i < resolution; ++i)
        for (const int instance : {instanceAt(i, 0), instanceAt(i, resolution - 1), instanceAt(0, i),
                                   instanceAt(resolution - 1, i)})
            open += instance < 0;
    const glm::dvec3& eye = view.eye;
    const bool isInside = glm::all(glm::lessThan(scene.boundsWorld.min, eye)) &&
                          glm::all(glm::lessThan(eye, scene.boundsWorld.max));
    if (open < (isInside ? minOpenEdgeInside : minOpenEdgeOutside) * 4 * resolution) return {};
    for (int y = 1; y + 1 < resolution; ++y) {
        for (int x = 1; x + 1 < resolution; ++x) {
            const int instance = instanceAt(x, y);
            if (instance < 0 || std::min({instanceAt(x - 1, y), instanceAt(x + 1, y), instanceAt(x, y - 1),
                                          instanceAt(x, y + 1)}) >= 0)
                continue;
            const int mesh = scene.instances[static_cast<std::size_t>(instance)].mesh;
            const int material = scene.meshes[static_cast<std::size_t>(mesh)].material;
            albedos.push_back(perMaterial[static_cast<std::size_t>(material)]);
        }
    }
    return albedos;
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
        if (isLitByEmitters(scene))
            light.intensity = 0.0F;
        else if (isProduct(scene))
            light.intensity *= studioSun;
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
    const TriangleTree tree(scene);
    const std::optional<glm::dvec3> inRoom = pointInRoom(tree, camera);
    if (!inRoom || isLitByEmitters(scene)) return {};
    glm::dvec3 place = *inRoom;
    Space space = spaceAround(tree, place);
    const auto moveTo = [&](const glm::dvec3& point) {
        const Space there = spaceAround(tree, point);
        if (!there.isRoom()) return;  // something is there
        place = point;
        space = there;
    };
    // A window may look narrow from beside it.
    if (!spaceAround(tree, space.middle).isSealed()) return {};
    moveTo(space.middle);
    moveTo(place + glm::dvec3(0.0, 0.6 * space.ceiling, 0.0));
    const double radius = std::cbrt(space.volume / (4.0 / 3.0 * pi));
    PunctualLight light;
    light.name = roomLightName;
    light.worldFromLight[3] = glm::dvec4(place, 1.0);
    light.intensity = static_cast<float>(std::clamp(pi * radius * radius, 1e-30, 1e30));
    return light;
}

bool isLitByRoomLight(const Scene& scene) {
    return scene.punctualLights.size() == 1 && scene.punctualLights.front().name == roomLightName;
}

std::string roomLightNote(const PunctualLight& light) {
    const glm::dvec4& place = light.worldFromLight[3];
    char text[200];
    std::snprintf(
        text, sizeof text,
        "note: the picture shows a closed room without a light; vct adds a point light of %.6g cd at "
        "%.6g,%.6g,%.6g",
        double{light.intensity}, place.x, place.y, place.z);
    return text;
}

DirectionalLight defaultLight() {
    DirectionalLight light;
    light.directionToLight = glm::normalize(glm::dvec3(0.5, 1.0, 0.75));
    light.intensity = static_cast<float>(pi);
    return light;
}

bool isOn(const DirectionalLight& light) {
    return light.intensity > 0.0F && light.color != glm::vec3(0.0F);
}

glm::vec3 chooseSky(const Scene& scene, const DirectionalLight& light) {
    if (!isOn(light)) return glm::vec3(0.0F);
    return isInStudio(scene) ? glm::vec3(studioSkyPerLux * illuminanceOf(light)) : plainSky(light);
}

bool isInStudio(const Scene& scene) {
    return scene.lights.empty() && scene.punctualLights.empty() && isProduct(scene) &&
           !isLitByEmitters(scene);
}

glm::vec3 plainSky(const DirectionalLight& light) {
    const float lux = isOn(light)              ? illuminanceOf(light)
                      : light.intensity > 0.0F ? light.intensity
                                               : defaultLight().intensity;
    return glm::vec3(0.2F, 0.25F, 0.35F) * static_cast<float>(lux / pi);
}

glm::vec3 chooseBackground(const Scene& scene, const Camera& camera, double aspect, const glm::vec3& sky) {
    const std::vector<float> albedos = albedosAtBackground(scene, camera, aspect);
    const auto& shares = isInStudio(scene) ? studioBackgroundShares : backgroundShares;
    float best = shares[0];
    auto least = static_cast<std::ptrdiff_t>(albedos.size()) + 1;
    for (const float share : shares) {
        const auto vanishing = std::count_if(albedos.begin(), albedos.end(), [&](float albedo) {
            return share > leastShade * albedo && share < mostShade * albedo;
        });
        // A twentieth of the outline may vanish.
        if (20 * vanishing <= static_cast<std::ptrdiff_t>(albedos.size())) return share * sky;
        if (vanishing >= least) continue;
        least = vanishing;
        best = share;
    }
    return best * sky;
}

glm::vec3 dimSky(const DirectionalLight& light) {
    return dimShare * plainSky(light);
}

}  // namespace vct
