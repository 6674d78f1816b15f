#include "engine/lamp_light.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <utility>

namespace vct {

namespace {

// Of all lamps' light, that the spots of walls beside them may lose: what they would need of the faces' 8
// bits all other surfaces would lack.
constexpr double mostLost = 0.02;
// Rays against triangles, to find those spots: a tenth of a second.
constexpr double mostTests = 1e7;

struct Triangle {
    glm::dvec3 a, ab, ac;
};

std::vector<Triangle> trianglesOf(const Scene& scene) {
    std::vector<Triangle> triangles;
    triangles.reserve(scene.triangleCount());
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const auto world = [&](std::size_t corner) {
            const glm::vec3& position = mesh.vertices[mesh.indices[corner]].position;
            return glm::dvec3(instance.worldFromObject * glm::dvec4(mesh.centre + glm::dvec3(position), 1.0));
        };
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const glm::dvec3 corner = world(i);
            triangles.push_back({corner, world(i + 1) - corner, world(i + 2) - corner});
        }
    }
    return triangles;
}

// What a ray meets first: cosine between it and the surface's normal over its squared length, where that is
// no shorter than `shortest`; 0 where it meets nothing. Moeller and Trumbore 1997.
double cosineOverSquare(const std::vector<Triangle>& triangles, const glm::dvec3& from,
                        const glm::dvec3& direction, double shortest) {
    double nearest = std::numeric_limits<double>::infinity(), cosine = 0.0;
    for (const Triangle& triangle : triangles) {
        const glm::dvec3 across = glm::cross(direction, triangle.ac);
        const double determinant = glm::dot(triangle.ab, across);
        const glm::dvec3 offset = from - triangle.a;
        const double u = glm::dot(offset, across) / determinant;
        if (!(u >= 0.0 && u <= 1.0)) continue;
        const glm::dvec3 along = glm::cross(offset, triangle.ab);
        const double v = glm::dot(direction, along) / determinant;
        const double distance = glm::dot(triangle.ac, along) / determinant;
        if (!(v >= 0.0 && u + v <= 1.0 && distance > 0.0 && distance < nearest)) continue;
        nearest = distance;
        cosine = std::abs(glm::dot(direction, glm::normalize(glm::cross(triangle.ab, triangle.ac))));
    }
    return cosine / std::pow(std::max(nearest, shortest), 2.0);
}

}  // namespace

LampLight lampLight(const Scene& scene, const std::vector<EmitterPart>& emitters, double voxelSize) {
    LampLight sums;
    const std::size_t lights = scene.punctualLights.size() + emitters.size();
    if (lights == 0) return sums;
    const std::vector<Triangle> triangles = trianglesOf(scene);
    const double rays =
        std::clamp(mostTests / static_cast<double>(triangles.size() * lights + 1), 16.0, 256.0);
    // Radiance of a white surface where rays of the lamps meet it, and each ray's flux over pi.
    std::vector<std::pair<double, double>> lit;
    for (const PunctualLight& light : scene.punctualLights) {
        if (light.type == PunctualLight::Type::directional) {
            sums.brightest = std::max(sums.brightest, light.intensity / glm::pi<double>());
            continue;
        }
        const double cosOuter = light.type == PunctualLight::Type::spot ? std::cos(light.outerConeRad) : -1.0;
        const double fluxOverPi = 2.0 * (1.0 - cosOuter) * light.intensity;
        sums.fluxOverPi += fluxOverPi;
        for (int i = 0; i < static_cast<int>(rays); ++i) {
            // A spiral of points a golden angle apart.
            const double cosine = 1.0 - (1.0 - cosOuter) * (i + 0.5) / std::floor(rays);
            const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0)), turn = 2.399963229728653 * i;
            const glm::dvec3 direction(light.worldFromLight * glm::dvec4(sine * std::cos(turn),
                                                                         sine * std::sin(turn), -cosine,
                                                                         0.0));
            const double met =
                cosineOverSquare(triangles, glm::dvec3(light.worldFromLight[3]), direction, voxelSize);
            lit.emplace_back(light.intensity * met / glm::pi<double>(), fluxOverPi / std::floor(rays));
        }
    }
    for (const EmitterPart& part : emitters) {
        const double radiance = std::max({part.radiance.r, part.radiance.g, part.radiance.b});
        sums.fluxOverPi += part.flux();
        for (int i = 0; i < static_cast<int>(rays); ++i) {
            const double turn = 2.399963229728653 * i, at = (i + 0.5) / std::floor(rays);
            // To all sides, or weighted by the cosine with what it faces.
            const double cosine = part.isRound() ? 1.0 - 2.0 * at : std::sqrt(1.0 - at);
            const double sine = std::sqrt(1.0 - cosine * cosine);
            const glm::dvec3 axis = part.isRound() ? glm::dvec3(0, 1, 0) : glm::normalize(part.facing);
            const glm::dvec3 aside = glm::normalize(
                glm::cross(axis, std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
            const glm::dvec3 direction = cosine * axis + sine * std::cos(turn) * aside +
                                         sine * std::sin(turn) * glm::cross(axis, aside);
            const double seen = part.isRound() ? 0.25 * part.area : glm::length(part.facing) * cosine;
            const glm::dvec3 from = part.centre + 1.01 * part.halfDepth * direction;
            const double met = cosineOverSquare(triangles, from, direction,
                                                std::max(voxelSize, std::sqrt(seen / glm::pi<double>())));
            lit.emplace_back(radiance * seen * met / glm::pi<double>(), part.flux() / std::floor(rays));
        }
    }
    // The least that cuts off no more than it may.
    std::sort(lit.begin(), lit.end());
    double sure = sums.brightest, fluxAbove = 0.0, lost = 0.0, at = lit.empty() ? 0.0 : lit.back().first;
    for (auto ray = lit.rbegin(); ray != lit.rend() && ray->first > sure; ++ray) {
        // A surface that would be so bright loses a share of its flux.
        lost += fluxAbove > 0.0 ? fluxAbove * (at - ray->first) / at : 0.0;
        if (lost > mostLost * sums.fluxOverPi) break;
        at = ray->first;
        fluxAbove += ray->second;
    }
    sums.brightest = std::max(sure, at);
    return sums;
}

}  // namespace vct
