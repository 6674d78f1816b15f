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

}  // namespace

std::vector<std::string> keepStrongestLights(Scene& scene, std::size_t most) {
    std::vector<PunctualLight>& lights = scene.punctualLights;
    if (lights.size() <= most) return {};
    const std::vector<Bounds> boxes = instanceBoxes(scene);
    const glm::dvec3 sides = scene.boundsWorld.max - scene.boundsWorld.min;
    const double nearest = nearestOfSide * std::max({sides.x, sides.y, sides.z});
    std::vector<double> lux;
    for (const PunctualLight& light : lights) {
        if (light.type == PunctualLight::Type::directional) {
            lux.push_back(light.intensity);
            continue;
        }
        double distance = HUGE_VAL;
        for (const Bounds& box : boxes)
            distance = std::min(distance, distanceToBox(box, glm::dvec3(light.worldFromLight[3])));
        const double used = std::max(distance, nearest);
        lux.push_back(distance < light.range ? light.intensity / (used * used) : 0.0);
    }
    std::vector<std::size_t> order(lights.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return lux[a] > lux[b]; });
    std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most));

    std::vector<PunctualLight> kept;
    std::vector<std::string> others;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i < most)
            kept.push_back(lights[order[i]]);
        else
            others.push_back(lights[order[i]].name.empty() ? "number " + std::to_string(order[i] + 1)
                                                           : '"' + lights[order[i]].name + '"');
    }
    lights = std::move(kept);
    return others;
}

}  // namespace vct
