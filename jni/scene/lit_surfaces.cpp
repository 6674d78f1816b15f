#include "scene/lit_surfaces.h"

namespace vct {
namespace {

constexpr std::size_t maxSources = 8;  // more would cost time, and a view needs to show only some light
constexpr double gapAtEnds = 1e-5;     // share of a ray's length at each of its ends that is not tested

}  // namespace

LitSurfaces::LitSurfaces(const Scene& scene, const TriangleTree& tree, bool emitters)
    : tree_(tree), emits_(scene.instances.size()) {
    const double diagonal = glm::length(scene.boundsWorld.max - scene.boundsWorld.min);
    const auto addSun = [&](const glm::dvec3& directionToLight) {
        sources_.push_back({diagonal * directionToLight, true});
    };
    for (const DirectionalLight& light : scene.lights)
        if (light.intensity > 0.0F) addSun(light.directionToLight);
    for (const PunctualLight& light : scene.punctualLights) {
        if (sources_.size() == maxSources || light.intensity <= 0.0F) continue;
        const glm::dvec3 back(light.worldFromLight[2]);
        if (light.type == PunctualLight::Type::directional) {
            addSun(back);
            continue;
        }
        Source& source = sources_.emplace_back(Source{glm::dvec3(light.worldFromLight[3])});
        source.range = light.range;
        if (light.type != PunctualLight::Type::spot) continue;
        source.axis = -back;
        source.minCosine = std::cos(light.outerConeRad);
    }
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[i].mesh)];
        emits_[i] = scene.materials[static_cast<std::size_t>(mesh.material)].emissive != glm::vec3(0.0F);
        if (!emits_[i] || !emitters || sources_.size() == maxSources) continue;
        const Bounds bounds = boundsOf(cornersOf(mesh), scene.instances[i].worldFromObject);
        sources_.push_back({0.5 * (bounds.min + bounds.max), false, true});
    }
}

bool LitSurfaces::reaches(const glm::dvec3& pointWorld, const FirstSurface& surface) const {
    if (surface.instance >= 0 && emits_[static_cast<std::size_t>(surface.instance)]) return true;
    for (const Source& source : sources_) {
        const glm::dvec3 light = source.isSun ? pointWorld + source.position : source.position;
        const glm::dvec3 fromLight = pointWorld - light;
        const double distance = glm::length(fromLight);
        if (distance > source.range || glm::dot(fromLight, surface.normal) >= 0.0 ||
            glm::dot(fromLight, source.axis) < source.minCosine * distance)
            continue;
        const FirstSurface first =
            tree_.first(light + gapAtEnds * fromLight, fromLight, 1.0 - 2.0 * gapAtEnds);
        if (first.distance == 0.0 && (first.backDistance == 0.0 || source.isEmitter)) return true;
    }
    return false;
}

}  // namespace vct
