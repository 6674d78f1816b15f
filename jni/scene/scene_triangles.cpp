// What gltf.h offers on the triangles of a loaded scene.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "core/error.h"
#include "scene/gltf.h"

namespace vct {
namespace {

// Beyond this a coordinate squared leaves the range of float.
constexpr double maxCoordinate = 1e18;

// Fisher and Yates; std::shuffle differs between standard libraries, and a seed must mean one order.
template <class T>
void shuffle(std::vector<T>& items, std::mt19937& random) {
    for (std::size_t i = items.size(); i > 1; --i)
        std::swap(items[i - 1], items[random() % i]);
}

// The corners of triangles, each vertex once, in object space.
std::vector<glm::dvec3> usedPositions(const Mesh& mesh) {
    std::vector<bool> used(mesh.vertices.size());
    for (const std::uint32_t index : mesh.indices)
        used[index] = true;
    std::vector<glm::dvec3> positions;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (used[i]) positions.push_back(mesh.centre + glm::dvec3(mesh.vertices[i].position));
    }
    return positions;
}

}  // namespace

void computeBounds(Scene& scene) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Bounds bounds{glm::dvec3(infinity), glm::dvec3(-infinity)};
    const std::string prefix = "cannot use the scene " + scene.path + ": ";
    if (scene.triangleCount() == 0) throw Error(prefix + "it has no triangles; export it with a mesh");

    std::vector<std::vector<const Instance*>> instancesOf(scene.meshes.size());
    for (const Instance& instance : scene.instances)
        instancesOf[static_cast<std::size_t>(instance.mesh)].push_back(&instance);
    for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
        if (instancesOf[mesh].empty()) continue;
        for (const glm::dvec3& position : usedPositions(scene.meshes[mesh])) {
            for (const Instance* instance : instancesOf[mesh]) {
                const glm::dvec3 world(instance->worldFromObject * glm::dvec4(position, 1.0));
                const double largest = std::max({std::abs(world.x), std::abs(world.y), std::abs(world.z)});
                if (!std::isfinite(world.x + world.y + world.z) || largest > maxCoordinate)
                    throw Error(
                        prefix + "the mesh \"" + scene.meshes[mesh].name +
                        "\" has a position that is not finite or beyond 1e18; correct its vertices or scale");
                bounds.min = glm::min(bounds.min, world);
                bounds.max = glm::max(bounds.max, world);
            }
        }
    }
    if (bounds.min == bounds.max)
        throw Error(prefix + "all of its triangles lie in one point; correct its vertices or scale");
    scene.boundsWorld = bounds;
}

void shuffleTriangles(Scene& scene, unsigned seed) {
    if (seed == 0) return;
    std::mt19937 random(seed);
    shuffle(scene.instances, random);
    for (Mesh& mesh : scene.meshes) {
        std::vector<std::array<std::uint32_t, 3>> triangles(mesh.indices.size() / 3);
        for (std::size_t i = 0; i < triangles.size(); ++i)
            triangles[i] = {mesh.indices[3 * i], mesh.indices[3 * i + 1], mesh.indices[3 * i + 2]};
        shuffle(triangles, random);
        for (std::size_t i = 0; i < triangles.size(); ++i)
            std::copy(triangles[i].begin(), triangles[i].end(),
                      mesh.indices.begin() + static_cast<std::ptrdiff_t>(3 * i));
    }
}

}  // namespace vct
