#include "scene/first_surfaces.h"

#include <algorithm>
#include <cmath>

namespace vct {

FirstSurfaces::FirstSurfaces(const glm::dvec3& eyeWorld, const glm::dmat3& axes, double tanWidth,
                             double tanHeight, int directionsPerSide)
    : eye(eyeWorld),
      worldFromView(axes),
      tanHalfWidth(tanWidth),
      tanHalfHeight(tanHeight),
      resolution(directionsPerSide),
      samples(static_cast<std::size_t>(directionsPerSide) * directionsPerSide) {}

glm::dvec3 FirstSurfaces::direction(std::size_t sample) const {
    const double x = static_cast<double>(sample % resolution), y = static_cast<double>(sample / resolution);
    return worldFromView * glm::dvec3((2.0 * (x + 0.5) / resolution - 1.0) * tanHalfWidth,
                                      (2.0 * (y + 0.5) / resolution - 1.0) * tanHalfHeight, -1.0);
}

double FirstSurfaces::solidAngle(std::size_t sample) const {
    const glm::dvec3 d = direction(sample);
    const double area = 4.0 * tanHalfWidth * tanHalfHeight / (1.0 * resolution * resolution);
    return area / std::pow(glm::dot(d, d), 1.5);
}

void FirstSurfaces::draw(const glm::dvec3 (&cornersWorld)[3], const glm::dvec3& normalWorld, bool doubleSided,
                         int instance) {
    // Height of the eye below the front, times the normal's length. It is tested first, so that culled
    // triangles cost nothing else.
    const double height = glm::dot(cornersWorld[0] - eye, normalWorld);
    const bool front = height < 0.0;
    const bool visible = front || doubleSided;
    if (height == 0.0 || !(visible || findsBacks)) return;
    const glm::dmat3 viewFromWorld = glm::transpose(worldFromView);
    glm::dvec3 p[3];
    for (int i = 0; i < 3; ++i)
        p[i] = viewFromWorld * (cornersWorld[i] - eye);
    const double nearest = std::max({p[0].z, p[1].z, p[2].z}), farthest = std::min({p[0].z, p[1].z, p[2].z});
    if (farthest >= 0.0) return;

    glm::ivec2 first(0), last(resolution - 1);
    if (nearest < 0.0) {  // all in front of the eye, so it covers at most the bounds of its corners
        glm::dvec2 low(HUGE_VAL), high(-HUGE_VAL);
        for (const glm::dvec3& corner : p) {
            const glm::dvec2 at = glm::dvec2(corner) / (-corner.z * glm::dvec2(tanHalfWidth, tanHalfHeight));
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
        const auto pixel = [&](const glm::dvec2& at) {
            return glm::clamp(0.5 * resolution * (at + 1.0) - 0.5, -1.0, static_cast<double>(resolution));
        };
        first = glm::max(first, glm::ivec2(glm::ceil(pixel(low))));
        last = glm::min(last, glm::ivec2(glm::floor(pixel(high))));
        if (first.x > last.x || first.y > last.y) return;
    }
    // A direction meets the triangle if it lies on the same side of the three planes through the eye and an
    // edge.
    const glm::dvec3 edges[3] = {glm::cross(p[1], p[2]), glm::cross(p[2], p[0]), glm::cross(p[0], p[1])};
    const double side = front ? -1.0 : 1.0;
    const glm::dvec3 normal = viewFromWorld * normalWorld;
    const double area = 0.5 * glm::length(normalWorld);
    const glm::dvec3 seenNormal = glm::normalize(-side * normalWorld);
    const glm::dvec2 step = 2.0 * glm::dvec2(tanHalfWidth, tanHalfHeight) / static_cast<double>(resolution);
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            const glm::dvec3 d((x + 0.5) * step.x - tanHalfWidth, (y + 0.5) * step.y - tanHalfHeight, -1.0);
            if (side * glm::dot(d, edges[0]) < 0.0 || side * glm::dot(d, edges[1]) < 0.0 ||
                side * glm::dot(d, edges[2]) < 0.0)
                continue;
            const double depth = height / glm::dot(d, normal);
            Sample& sample = samples[static_cast<std::size_t>(y) * resolution + x];
            if (!(depth > 0.0)) continue;
            if (!visible) {
                if (sample.backDepth == 0.0 || depth < sample.backDepth) sample.backDepth = depth;
                continue;
            }
            const bool same = std::abs(sample.depth - depth) < 1e-6 * depth;
            if (sample.depth > 0.0 && (same ? sample.area >= area : sample.depth < depth)) continue;
            sample = {depth, seenNormal, instance, area, sample.backDepth};
        }
    }
}

void drawFirstSurfaces(const Scene& scene, std::vector<FirstSurfaces>& views) {
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const bool doubleSided = scene.materials[static_cast<std::size_t>(mesh.material)].doubleSided;
        const bool mirrored = glm::determinant(glm::dmat3(instance.worldFromObject)) < 0.0;
        for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
            glm::dvec3 corners[3];
            for (std::size_t k = 0; k < 3; ++k) {
                const Vertex& vertex = mesh.vertices[mesh.indices[t + (mirrored ? 2 - k : k)]];
                corners[k] = glm::dvec3(instance.worldFromObject *
                                        glm::dvec4(mesh.centre + glm::dvec3(vertex.position), 1.0));
            }
            const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
            for (FirstSurfaces& view : views)
                view.draw(corners, normal, doubleSided, static_cast<int>(i));
        }
    }
}

std::vector<FirstSurfaces> viewsAround(const glm::dvec3& eyeWorld, int directionsPerSide) {
    const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    std::vector<FirstSurfaces> views;
    for (const glm::dmat3& axes : {glm::dmat3(x, y, z), glm::dmat3(-x, y, -z), glm::dmat3(-z, y, x),
                                   glm::dmat3(z, y, -x), glm::dmat3(x, -z, y), glm::dmat3(x, z, -y)})
        views.emplace_back(eyeWorld, axes, 1.0, 1.0, directionsPerSide);
    return views;
}

}  // namespace vct
