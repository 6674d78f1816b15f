#include "scene/gltf_nodes.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <set>

#include "scene/gltf_extensions.h"

namespace vct {
namespace {

constexpr int maxDepth = 1000;  // limit of nesting; real hierarchies have less than a hundred levels

std::string named(const GltfFile& file, const tinygltf::Node& node) {
    const auto index = static_cast<std::size_t>(&node - file.model.nodes.data());
    return "node " + indexAndName(index, node.name);
}

NodeTransform localTransform(const GltfFile& file, const tinygltf::Node& node) {
    const auto wrongSize = [](const std::vector<double>& values, std::size_t size) {
        return !values.empty() && values.size() != size;
    };
    if (wrongSize(node.matrix, 16) || wrongSize(node.translation, 3) || wrongSize(node.rotation, 4) ||
        wrongSize(node.scale, 3))
        file.fail(named(file, node) + " has a transformation with a wrong number of elements");

    NodeTransform transform;
    if (!node.matrix.empty()) {
        glm::dmat4 matrix;
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        if (matrix[0][3] != 0.0 || matrix[1][3] != 0.0 || matrix[2][3] != 0.0 || matrix[3][3] != 1.0)
            file.fail(named(file, node) + " has a matrix whose last row is not 0 0 0 1");
        transform.matrix = matrix;
        return transform;
    }
    const auto three = [](const std::vector<double>& v) { return glm::dvec3(v[0], v[1], v[2]); };
    if (!node.translation.empty()) transform.translation = three(node.translation);
    if (!node.rotation.empty()) {
        const glm::dquat rotation(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
        const double length = glm::length(rotation);
        if (!(length > 1e-6) || !std::isfinite(length))
            file.fail(named(file, node) + " has a rotation that is not a unit quaternion");
        transform.rotation = rotation / length;
    }
    if (!node.scale.empty()) transform.scale = three(node.scale);
    return transform;
}

bool hidesItself(const tinygltf::Node& node) {
    const tinygltf::Value* const visibility = extensionOf(node.extensions, "KHR_node_visibility");
    if (visibility == nullptr || !visibility->IsObject() || !visibility->Has("visible")) return false;
    const tinygltf::Value& visible = visibility->Get("visible");
    return visible.IsBool() && !visible.Get<bool>();
}

}  // namespace

std::vector<int> rootsOf(const GltfFile& file) {
    const tinygltf::Model& model = file.model;
    if (!model.scenes.empty()) {
        const int scene = model.defaultScene == -1 ? 0 : model.defaultScene;
        return file.at(model.scenes, scene, "scene").nodes;
    }
    std::set<int> children;
    for (const tinygltf::Node& node : model.nodes)
        children.insert(node.children.begin(), node.children.end());
    std::vector<int> roots;
    for (int i = 0; i < static_cast<int>(model.nodes.size()); ++i)
        if (children.count(i) == 0) roots.push_back(i);
    return roots;
}

void checkFinite(const GltfFile& file, const glm::dmat4& matrix, const tinygltf::Node& node) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!(std::abs(matrix[column][row]) <= 1e30))
                file.fail(named(file, node) + " has a transformation that is not a usable number");
        }
    }
}

std::vector<PlacedNode> placeNodes(const GltfFile& file) {
    struct Pending {
        int node;
        int depth;
        int parent;  // index into `placed`, or -1
    };
    std::vector<Pending> pending;
    const std::vector<int> roots = rootsOf(file);
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
        pending.push_back({*root, 1, -1});

    std::vector<PlacedNode> placed;
    std::vector<bool> visited(file.model.nodes.size());
    while (!pending.empty()) {
        const Pending next = pending.back();
        pending.pop_back();
        const tinygltf::Node& node = file.at(file.model.nodes, next.node, "node");
        const auto index = static_cast<std::size_t>(next.node);
        // Without this check a cycle would never end, and shared children could be placed any number of
        // times.
        if (visited[index])
            file.fail(named(file, node) +
                      " is in the scene twice: it has two parents, or is its own ancestor");
        visited[index] = true;
        if (next.depth > maxDepth)
            file.fail("its nodes are nested more than " + std::to_string(maxDepth) + " levels deep");
        const glm::dmat4 worldFromParent =
            next.parent < 0 ? glm::dmat4(1.0) : placed[static_cast<std::size_t>(next.parent)].worldFromNode;
        const NodeTransform transform = localTransform(file, node);
        const glm::dmat4 worldFromNode = worldFromParent * transform.parentFromNode();
        checkFinite(file, worldFromNode, node);
        const int self = static_cast<int>(placed.size());
        placed.push_back({&node, worldFromNode, transform, next.parent});
        placed.back().isVisible =
            !hidesItself(node) &&
            (next.parent < 0 || placed[static_cast<std::size_t>(next.parent)].isVisible);
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
            pending.push_back({*child, next.depth + 1, self});
    }
    return placed;
}

namespace {

// Makes `camera` show the width and height that an orthographic camera frames, at the depth of the scene's
// centre. Its eye stays, but lies at least half that height in front of the centre; from a shorter distance
// the perspective would be too strong.
void makePerspective(const tinygltf::OrthographicCamera& source, const Bounds& bounds, Camera& camera) {
    const double halfHeight = std::abs(source.ymag);
    const glm::dvec3 fromEye = 0.5 * (bounds.min + bounds.max) - glm::dvec3(camera.worldFromCamera[3]);
    const double depth = -glm::dot(glm::dvec3(camera.worldFromCamera[2]), fromEye);
    camera.setBack = std::max(halfHeight - depth, 0.0);
    camera.worldFromCamera[3] += camera.setBack * camera.worldFromCamera[2];
    camera.verticalFovRad = 2.0 * std::atan(halfHeight / (depth + camera.setBack));
    camera.aspectRatio = std::abs(source.xmag) / halfHeight;
}

}  // namespace

void addCameras(GltfFile& file, const std::vector<PlacedNode>& nodes, Scene& scene) {
    std::vector<Camera> orthographic;
    for (const PlacedNode& placed : nodes) {
        if (placed.node->camera == -1) continue;
        const tinygltf::Camera& source = file.at(file.model.cameras, placed.node->camera, "camera");
        Camera camera;
        camera.name = source.name.empty() ? placed.node->name : source.name;
        const std::string named =
            "camera " + indexAndName(static_cast<std::size_t>(placed.node->camera), camera.name);
        const std::optional<glm::dmat4> worldFromCamera = withoutScale(placed.worldFromNode);
        if (!worldFromCamera) {
            file.warn("a camera without an orientation (zero scale) is left out");
            continue;
        }
        camera.worldFromCamera = *worldFromCamera;
        camera.node = placed.moving;
        if (source.type == "perspective") {
            camera.verticalFovRad = source.perspective.yfov;
            if (source.perspective.znear > 0.0) camera.nearest = source.perspective.znear;
            if (source.perspective.aspectRatio > 0.0) camera.aspectRatio = source.perspective.aspectRatio;
            if (!(camera.verticalFovRad > 0.0 && camera.verticalFovRad < 3.14159265358979))
                file.fail(named + " has a field of view that is not between 0 and 180 degrees");
            scene.cameras.push_back(std::move(camera));
            continue;
        }
        const double width = std::abs(source.orthographic.xmag), height = std::abs(source.orthographic.ymag);
        if (!(width > 0.0 && height > 0.0 && std::isfinite(width / height) &&
              std::isfinite(height / width))) {
            file.warn("orthographic " + named + " frames nothing (xmag or ymag is 0) and is left out");
            continue;
        }
        makePerspective(source.orthographic, scene.boundsWorld, camera);
        file.warn("orthographic " + named +
                  " is drawn in perspective, and frames the same area at the depth of the scene's centre");
        orthographic.push_back(std::move(camera));
    }
    scene.cameras.insert(scene.cameras.end(), orthographic.begin(), orthographic.end());
}

}  // namespace vct
