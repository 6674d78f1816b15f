// Implements computeBounds() and boundsOfPoses() of gltf.h.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"
#include "core/number_text.h"
#include "scene/gltf.h"

namespace vct {
namespace {

// The square of a larger coordinate exceeds the range of float.
constexpr double maxCoordinate = 1e18;

// Positions of the vertices that triangles use, each once, in object space.
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

// The times of all keys and three times between each two, thinned out evenly to at most `most` times.
std::vector<double> poseTimes(const Animation& animation, std::size_t most) {
    std::vector<double> keys;
    for (const AnimationChannel& channel : animation.channels)
        keys.insert(keys.end(), channel.times.begin(), channel.times.end());
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    std::vector<double> times;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        times.push_back(keys[i]);
        for (int quarter = 1; quarter < 4 && i + 1 < keys.size(); ++quarter)
            times.push_back(keys[i] + 0.25 * quarter * (keys[i + 1] - keys[i]));
    }
    if (times.size() <= most) return times;
    std::vector<double> some;
    for (std::size_t i = 0; i < most; ++i)
        some.push_back(times[i * (times.size() - 1) / (most - 1)]);
    return some;
}

bool isUsable(const glm::dvec3& world) {
    const double largest = std::max({std::abs(world.x), std::abs(world.y), std::abs(world.z)});
    return std::isfinite(world.x + world.y + world.z) && largest <= maxCoordinate;
}

}  // namespace

Bounds boundsOfPoses(const Scene& scene, const Bounds& rest, const Bounds& limit) {
    struct Moving {
        int node;
        const std::vector<glm::dvec3>* positions;
        std::vector<glm::dvec3> corners;  // corners of the box around the positions
    };
    struct Deforming {
        const Deformation* deformation;
        DeformationBoxes boxes;
    };
    std::map<int, std::vector<glm::dvec3>> positionsOf;  // vertices of the moving meshes
    std::vector<Moving> moving;
    std::vector<Deforming> deforming;
    std::size_t work = scene.animation.nodes.size();
    for (const Instance& instance : scene.instances) {
        if (!instance.moves()) continue;
        if (instance.deforms) {
            const Deformation& deformation = *scene.meshes[instance.mesh].deformation;
            deforming.push_back({&deformation, DeformationBoxes(deformation)});
            work += deformation.positions.size() * (8 + deformation.targets.size());
            continue;
        }
        const auto [found, added] = positionsOf.try_emplace(instance.mesh);
        if (added) found->second = usedPositions(scene.meshes[instance.mesh]);
        moving.push_back(
            {instance.node, &found->second, cornersOf(boundsOf(found->second, glm::dmat4(1.0)))});
        work += found->second.size();
    }

    Bounds bounds = rest;
    // Returns `bounds`, enlarged by the part of this box that lies in `limit`.
    const auto reach = [&](const Bounds& reached) {
        return united(bounds, {glm::max(reached.min, limit.min), glm::min(reached.max, limit.max)});
    };
    // Most poses stay inside of the bounds, which their box shows without testing all vertices.
    const auto include = [&](const Bounds& box, const auto& exactBounds) {
        const Bounds with = reach(box);
        if (with.min != bounds.min || with.max != bounds.max) bounds = reach(exactBounds());
    };
    const auto check = [&](const glm::dvec3& world, double seconds) {
        if (isUsable(world)) return;
        throw Error("cannot use the scene " + scene.path + ": at " + numberText(seconds) +
                    " s its animation \"" + scene.animation.name +
                    "\" moves a mesh beyond 1e18 or to a position that is not finite; correct its values");
    };
    // Limits the time to a second or two for any file.
    const std::size_t most =
        std::max<std::size_t>(16, (std::size_t{1} << 28) / std::max<std::size_t>(work, 1));
    for (const double seconds : poseTimes(scene.animation, most)) {
        const Pose pose = poseAt(scene.animation, seconds);
        for (const Moving& m : moving) {
            const glm::dmat4& worldFromObject = pose.worldFromNode[m.node];
            const Bounds box = boundsOf(m.corners, worldFromObject);
            for (const glm::dvec3& corner : m.corners)
                check(glm::dvec3(worldFromObject * glm::dvec4(corner, 1.0)), seconds);
            include(box, [&] { return boundsOf(*m.positions, worldFromObject); });
        }
        for (const Deforming& d : deforming) {
            const DeformationState state = stateOf(*d.deformation, &pose);
            const Bounds box = d.boxes.around(state, glm::dmat4(1.0));
            check(box.min, seconds);
            check(box.max, seconds);
            for (const glm::dmat4& matrix : state.worldFromObject)
                for (int column = 0; column < 4; ++column)
                    check(glm::dvec3(matrix[column]), seconds);
            include(box, [&] {
                Bounds exact = noBounds;
                for (std::size_t i = 0; i < d.deformation->positions.size(); ++i)
                    exact.include(deformedVertex(*d.deformation, state, i).positionWorld);
                return exact;
            });
        }
    }
    return bounds;
}

void computeBounds(Scene& scene) {
    Bounds bounds = noBounds;
    const std::string prefix = "cannot use the scene " + scene.path + ": ";
    if (scene.triangleCount() == 0) throw Error(prefix + "it has no triangles; export it with a mesh");

    std::vector<std::vector<const Instance*>> instancesOf(scene.meshes.size());
    for (const Instance& instance : scene.instances)
        instancesOf[instance.mesh].push_back(&instance);
    for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
        if (instancesOf[mesh].empty()) continue;
        for (const glm::dvec3& position : usedPositions(scene.meshes[mesh])) {
            for (const Instance* instance : instancesOf[mesh]) {
                const glm::dvec3 world(instance->worldFromObject * glm::dvec4(position, 1.0));
                if (!isUsable(world))
                    throw Error(
                        prefix + "\"" + scene.meshes[mesh].name +
                        "\" has a position that is not finite or beyond 1e18; correct its vertices or scale");
                bounds.include(world);
            }
        }
    }
    const glm::dvec3 extent = bounds.max - bounds.min;
    const double reach = 0.5 * std::max({extent.x, extent.y, extent.z});
    // A scene that is a point at rest has no size, so its animation is not limited.
    const double limit = reach > 0.0 ? reach : maxCoordinate;
    if (!scene.animation.channels.empty())
        bounds = boundsOfPoses(scene, bounds, {bounds.min - limit, bounds.max + limit});
    if (bounds.min == bounds.max)
        throw Error(prefix + "all of its triangles lie in one point; correct its vertices or scale");
    scene.boundsWorld = bounds;
}

std::vector<glm::dvec3> cornersOf(const Mesh& mesh) {
    std::vector<glm::dvec3> positions;
    for (const Vertex& vertex : mesh.vertices)
        positions.push_back(mesh.centre + glm::dvec3(vertex.position));
    return cornersOf(boundsOf(positions, glm::dmat4(1.0)));
}

}  // namespace vct
