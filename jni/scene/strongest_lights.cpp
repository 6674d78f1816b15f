#include "scene/strongest_lights.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace vct {
namespace {

constexpr double nearestOfSide = 0.1;

// The box around each instance at rest, in world space.
std::vector<Bounds> instanceBoxes(const Scene& scene) {
    std::map<int, std::vector<glm::dvec3>> cornersOfMesh;  // in object space
    std::vector<Bounds> boxes;
    for (const Instance& instance : scene.instances) {
        const auto [corners, isNew] = cornersOfMesh.try_emplace(instance.mesh);
        if (isNew) {
            const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
            Bounds box = noBounds;
            for (const std::uint32_t index : mesh.indices)
                box.include(mesh.centre + glm::dvec3(mesh.vertices[index].position));
            corners->second = cornersOf(box);
        }
        boxes.push_back(boundsOf(corners->second, instance.worldFromObject));
    }
    return boxes;
}

double distanceToBox(const Bounds& box, const glm::dvec3& p) {
    return glm::length(glm::max(glm::max(box.min - p, p - box.max), glm::dvec3(0.0)));
}

std::string nameOf(const PunctualLight& light, std::size_t index) {
    return light.name.empty() ? "number " + std::to_string(index + 1) : '"' + light.name + '"';
}

// Indices of the largest first. Equal ones keep their order.
std::vector<std::size_t> largestFirst(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
    return order;
}

}  // namespace

LightMeasure::LightMeasure(const Scene& scene) : boxes_(instanceBoxes(scene)) {
    const glm::dvec3 sides = scene.boundsWorld.max - scene.boundsWorld.min;
    nearest_ = nearestOfSide * std::max({sides.x, sides.y, sides.z});
}

double LightMeasure::of(const PunctualLight& light) const {
    if (light.type == PunctualLight::Type::directional) return light.intensity;
    double distance = HUGE_VAL;
    for (const Bounds& box : boxes_)
        distance = std::min(distance, distanceToBox(box, glm::dvec3(light.worldFromLight[3])));
    const double used = std::max(distance, nearest_);
    return distance < light.range ? light.intensity / (used * used) : 0.0;
}

std::vector<std::string> keepStrongestLights(Scene& scene, std::size_t most) {
    std::vector<PunctualLight>& lights = scene.punctualLights;
    if (lights.size() <= most) return {};
    const LightMeasure measure(scene);
    std::vector<double> lux;
    for (const PunctualLight& light : lights)
        lux.push_back(measure.of(light));
    std::vector<std::size_t> order = largestFirst(lux);
    std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most));

    std::vector<PunctualLight> kept;
    std::vector<std::string> others;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i < most)
            kept.push_back(lights[order[i]]);
        else
            others.push_back(nameOf(lights[order[i]], order[i]));
    }
    lights = std::move(kept);
    return others;
}

int shadowMapsOf(const PunctualLight& light) {
    using Type = PunctualLight::Type;
    const bool usesCube =
        light.type == Type::point || (light.type == Type::spot && light.outerConeRad > widestSpotMapRad);
    return usesCube ? 6 : 1;
}

std::vector<bool> lightsWithMaps(const std::vector<MeasuredLight>& lights, int room) {
    std::vector<double> measures;
    for (const MeasuredLight& light : lights)
        measures.push_back(light.measure);
    std::vector<bool> have(lights.size());
    for (const std::size_t i : largestFirst(measures)) {
        have[i] = lights[i].maps <= room;
        if (have[i]) room -= lights[i].maps;
    }
    return have;
}

std::vector<std::string> lightsWithoutMaps(const Scene& scene, int room) {
    const LightMeasure measure(scene);
    std::vector<MeasuredLight> lights;
    for (const PunctualLight& light : scene.punctualLights)
        lights.push_back({measure.of(light), shadowMapsOf(light)});
    const std::vector<bool> have = lightsWithMaps(lights, room);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < have.size(); ++i)
        if (!have[i]) names.push_back(nameOf(scene.punctualLights[i], i));
    return names;
}

}  // namespace vct
