#include "scene/subject.h"

#include <algorithm>

#include "scene/gltf.h"

namespace vct {
namespace {

// Largest height of a ground, in shares of its larger side, and largest height of its top above the scene's
// lowest point, in shares of the scene's height: objects may sink in a little. Water may be as high as a
// ground of its size may be thick, above a bed that only the water hides.
constexpr double flatness = 0.02, lowness = 0.05;
// A ground is at least so many times as wide as what stands on it. The floor of a room is as wide as its
// walls.
constexpr double minReach = 1.5;
// Largest sides of a product in metres. A larger object without a ground may be a room.
constexpr double maxProduct = 1.9, maxProductOnGround = 5.0;

Bounds boundsOf(const Scene& scene, const Instance& instance) {
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    std::vector<bool> isUsed(mesh.vertices.size());
    for (const std::uint32_t index : mesh.indices)
        isUsed[index] = true;
    Bounds bounds = noBounds;
    for (std::size_t i = 0; i < isUsed.size(); ++i)
        if (isUsed[i])
            bounds.include(glm::dvec3(instance.worldFromObject *
                                      glm::dvec4(mesh.centre + glm::dvec3(mesh.vertices[i].position), 1.0)));
    return bounds;
}

}  // namespace

Subject subjectOf(const Scene& scene) {
    Subject subject{scene.boundsWorld, std::vector<bool>(scene.instances.size()), false};
    const Bounds& all = scene.boundsWorld;
    const double highest = all.min.y + lowness * (all.max.y - all.min.y);
    std::vector<bool> isGround(scene.instances.size());
    Bounds ground = noBounds, others = noBounds;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Bounds bounds = boundsOf(scene, scene.instances[i]);
        const glm::dvec3 size = bounds.max - bounds.min;
        const double maxThickness = flatness * std::max(size.x, size.z);
        isGround[i] = !scene.instances[i].moves() && size.y <= maxThickness &&
                      bounds.max.y <= std::max(highest, all.min.y + maxThickness);
        Bounds& sum = isGround[i] ? ground : others;
        sum = united(sum, bounds);
    }
    // Empty bounds stay empty, because only what is there moves.
    if (!scene.animation.channels.empty()) others = boundsOfPoses(scene, others, all);
    const auto reaches = [&](int axis) {
        return ground.min[axis] <= others.min[axis] && ground.max[axis] >= others.max[axis] &&
               ground.max[axis] - ground.min[axis] >= minReach * (others.max[axis] - others.min[axis]);
    };
    // Both are empty where there is no ground, or nothing else.
    if (!(ground.min.x <= ground.max.x) || !(others.min.x <= others.max.x) || !reaches(0) || !reaches(2))
        return subject;
    return {others, std::move(isGround), true};
}

bool isProduct(const Scene& scene) {
    if (scene.instances.empty()) return false;
    const Subject subject = subjectOf(scene);
    const glm::dvec3 size = subject.boundsWorld.max - subject.boundsWorld.min;
    return std::max({size.x, size.y, size.z}) <= (subject.hasGround ? maxProductOnGround : maxProduct);
}

}  // namespace vct
