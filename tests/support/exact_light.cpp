#include "support/exact_light.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vct::test {

namespace {

constexpr double nothing = std::numeric_limits<double>::infinity();

// Along the ray (Moeller and Trumbore 1997).
double crossing(const ExactLight::Triangle& t, const glm::dvec3& origin, const glm::dvec3& direction) {
    const glm::dvec3 ab = t.b - t.a, ac = t.c - t.a;
    const glm::dvec3 p = glm::cross(direction, ac);
    const double determinant = glm::dot(ab, p);
    if (std::abs(determinant) < 1e-14) return nothing;
    const glm::dvec3 s = origin - t.a;
    const double u = glm::dot(s, p) / determinant;
    if (u < 0.0 || u > 1.0) return nothing;
    const glm::dvec3 q = glm::cross(s, ab);
    const double v = glm::dot(direction, q) / determinant;
    if (v < 0.0 || u + v > 1.0) return nothing;
    return glm::dot(ac, q) / determinant;
}

double distanceToSegment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 ab = b - a;
    const double t = glm::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
    return glm::length(p - a - t * ab);
}

bool isInside(const ExactLight::Triangle& t, const glm::dvec3& p) {
    return glm::dot(glm::cross(t.b - t.a, p - t.a), t.normal) >= 0.0 &&
           glm::dot(glm::cross(t.c - t.b, p - t.b), t.normal) >= 0.0 &&
           glm::dot(glm::cross(t.a - t.c, p - t.c), t.normal) >= 0.0;
}

double distanceTo(const ExactLight::Triangle& t, const glm::dvec3& p) {
    const double height = glm::dot(p - t.a, t.normal);
    if (isInside(t, p - height * t.normal)) return std::abs(height);
    return std::min(
        {distanceToSegment(p, t.a, t.b), distanceToSegment(p, t.b, t.c), distanceToSegment(p, t.c, t.a)});
}

}  // namespace

ExactLight::ExactLight(const Scene& scene)
    : tolerance_(1e-5 * glm::length(scene.boundsWorld.max - scene.boundsWorld.min)) {
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const auto world = [&](std::uint32_t i) {
            const glm::dvec3 p = mesh.centre + glm::dvec3(mesh.vertices[i].position);
            return glm::dvec3(instance.worldFromObject * glm::dvec4(p, 1.0));
        };
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            Triangle t{
                world(mesh.indices[i]), world(mesh.indices[i + 1]), world(mesh.indices[i + 2]), {}, false};
            t.normal = glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
            t.doubleSided = scene.materials[static_cast<std::size_t>(mesh.material)].doubleSided;
            triangles_.push_back(t);
        }
    }
    for (const Triangle& a : triangles_)
        for (const Triangle& b : triangles_)
            coplanar_.push_back(std::abs(glm::dot(a.normal, b.normal)) > 1.0 - 1e-9 &&
                                std::abs(glm::dot(b.a - a.a, a.normal)) < tolerance_);
}

int ExactLight::triangleAt(const glm::dvec3& position, const glm::dvec3& normal) const {
    int found = -1;
    double distance = tolerance_;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const Triangle& t = triangles_[i];
        const double cosine = glm::dot(t.normal, normal);
        if ((t.doubleSided ? std::abs(cosine) : cosine) < 0.999) continue;
        if (std::abs(glm::dot(position - t.a, t.normal)) >= distance) continue;
        const double d = distanceTo(t, position);
        if (d < distance) {
            distance = d;
            found = static_cast<int>(i);
        }
    }
    return found;
}

glm::dvec3 ExactLight::onPlane(const glm::dvec3& position, int triangle) const {
    const Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
    return position - glm::dot(position - t.a, t.normal) * t.normal;
}

bool ExactLight::covered(const glm::dvec3& position, int triangle) const {
    for (std::size_t i = 0; i < triangles_.size(); ++i)
        if (coplanar(triangle, i) && isInside(triangles_[i], position)) return true;
    return false;
}

bool ExactLight::sees(const glm::dvec3& position, int triangle, const glm::dvec3& towardsLight) const {
    for (std::size_t i = 0; i < triangles_.size(); ++i)
        if (!coplanar(triangle, i)) {
            const double distance = crossing(triangles_[i], position, towardsLight);
            if (distance > -tolerance_ && distance < nothing) return false;
        }
    return true;
}

bool ExactLight::litNeighbour(const glm::dvec3& position, const glm::dvec3& ray,
                              const glm::dvec3& towardsLight, double reach) const {
    double highest = -nothing;
    const Triangle* first = nullptr;
    for (const Triangle& triangle : triangles_) {
        const double distance = crossing(triangle, ray, towardsLight);
        if (distance == nothing || distance <= highest) continue;
        highest = distance;
        first = &triangle;
    }
    if (first == nullptr) return false;
    const glm::dvec3 fromHit = position - ray - highest * towardsLight;
    const double lit = glm::dot(first->normal, towardsLight);
    return (lit > 0.0 || first->doubleSided) && glm::length(fromHit) < reach &&
           glm::dot(first->normal, fromHit) * lit > 0.0;
}

double ExactLight::distanceToOthers(const glm::dvec3& position, int triangle, double limit) const {
    double distance = limit;
    for (std::size_t i = 0; i < triangles_.size(); ++i)
        if (!coplanar(triangle, i) &&
            std::abs(glm::dot(position - triangles_[i].a, triangles_[i].normal)) < distance)
            distance = std::min(distance, distanceTo(triangles_[i], position));
    return distance;
}

}  // namespace vct::test
