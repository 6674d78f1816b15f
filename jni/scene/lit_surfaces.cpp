#include "scene/lit_surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vct {
namespace {

constexpr std::size_t maxSources = 8;  // more would cost time, and a view needs to show only some light
constexpr int pointResolution = 32, sunResolution = 96;
constexpr double tolerance = 0.02;  // of a view's width or of the distance, because samples are coarse

Bounds instanceBounds(const Scene& scene, const Instance& instance) {
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    Bounds bounds = noBounds;
    for (const Vertex& vertex : mesh.vertices)
        bounds.include(glm::dvec3(instance.worldFromObject *
                                  glm::dvec4(mesh.centre + glm::dvec3(vertex.position), 1.0)));
    return bounds;
}

}  // namespace

LitSurfaces::LitSurfaces(const Scene& scene, bool emitters) : emits_(scene.instances.size()) {
    for (const DirectionalLight& light : scene.lights)
        if (light.intensity > 0.0F) addSun(scene, light.directionToLight);
    for (const PunctualLight& light : scene.punctualLights) {
        if (sources_.size() == maxSources || light.intensity <= 0.0F) continue;
        const glm::dvec3 back(light.worldFromLight[2]);
        if (light.type == PunctualLight::Type::directional) {
            addSun(scene, back);
            continue;
        }
        addAround(glm::dvec3(light.worldFromLight[3]));
        sources_.back().range = light.range;
        if (light.type != PunctualLight::Type::spot) continue;
        sources_.back().axis = -back;
        sources_.back().minCosine = std::cos(light.outerConeRad);
    }
    // Backs of surfaces stop light too, but the centre of an emitter may lie behind its own surface.
    for (Source& source : sources_)
        for (FirstSurfaces& view : source.views)
            view.findsBacks = true;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[i].mesh)];
        emits_[i] = scene.materials[static_cast<std::size_t>(mesh.material)].emissive != glm::vec3(0.0F);
        if (!emits_[i] || !emitters || sources_.size() == maxSources) continue;
        const Bounds bounds = instanceBounds(scene, scene.instances[i]);
        addAround(0.5 * (bounds.min + bounds.max));
    }
    std::vector<FirstSurfaces> views;
    for (const Source& source : sources_)
        views.insert(views.end(), source.views.begin(), source.views.end());
    drawFirstSurfaces(scene, views);
    auto drawn = views.begin();
    for (Source& source : sources_)
        for (FirstSurfaces& view : source.views)
            view = std::move(*drawn++);
}

void LitSurfaces::addAround(const glm::dvec3& eyeWorld) {
    sources_.push_back(
        {viewsAround(eyeWorld, pointResolution), std::numeric_limits<double>::infinity(), {}, -1.0});
}

void LitSurfaces::addSun(const Scene& scene, const glm::dvec3& directionToLight) {
    // From so far away that its rays are parallel.
    constexpr double distance = 1e3;  // in diagonals of the scene
    const double diagonal = glm::length(scene.boundsWorld.max - scene.boundsWorld.min);
    const glm::dvec3 centre = 0.5 * (scene.boundsWorld.min + scene.boundsWorld.max);
    const glm::dvec3 helper = std::abs(directionToLight.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(helper, directionToLight));
    const double tanHalf = 0.5 / distance;
    sources_.push_back({{{centre + distance * diagonal * directionToLight,
                          {right, glm::cross(directionToLight, right), directionToLight},
                          tanHalf,
                          tanHalf,
                          sunResolution}},
                        std::numeric_limits<double>::infinity(),
                        {},
                        -1.0});
}

bool LitSurfaces::reaches(const glm::dvec3& pointWorld, const FirstSurfaces::Sample& surface) const {
    if (surface.instance >= 0 && emits_[static_cast<std::size_t>(surface.instance)]) return true;
    for (const Source& source : sources_) {
        const glm::dvec3 fromLight = pointWorld - source.views.front().eye;
        const double distance = glm::length(fromLight);
        if (distance > source.range || glm::dot(fromLight, surface.normal) >= 0.0 ||
            glm::dot(fromLight, source.axis) < source.minCosine * distance)
            continue;
        for (const FirstSurfaces& view : source.views) {
            const glm::dvec3 p = glm::transpose(view.worldFromView) * fromLight;
            if (p.z >= 0.0) continue;
            const glm::dvec2 at = glm::dvec2(p) / (-p.z * glm::dvec2(view.tanHalfWidth, view.tanHalfHeight));
            if (std::abs(at.x) > 1.0 || std::abs(at.y) > 1.0) continue;
            const glm::ivec2 pixel =
                glm::min(glm::ivec2(0.5 * (at + 1.0) * static_cast<double>(view.resolution)),
                         glm::ivec2(view.resolution - 1));
            const FirstSurfaces::Sample& first =
                view.samples[static_cast<std::size_t>(pixel.y) * view.resolution + pixel.x];
            const double nearest = (1.0 - tolerance * std::min(2.0 * view.tanHalfWidth, 1.0)) * -p.z;
            if ((first.depth == 0.0 || first.depth > nearest) &&
                (first.backDepth == 0.0 || first.backDepth > nearest))
                return true;
        }
    }
    return false;
}

}  // namespace vct
