#include "scene/gltf.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <new>

#include "core/error.h"
#include "core/list_text.h"
#include "core/memory.h"
#include "scene/gltf_deformations.h"
#include "scene/gltf_file.h"
#include "scene/gltf_instancing.h"
#include "scene/gltf_lights.h"
#include "scene/gltf_materials.h"
#include "scene/gltf_nodes.h"
#include "scene/gltf_packings.h"
#include "scene/strongest_lights.h"
#include "shared/layout.h"

namespace vct {
namespace {

// Limits that only a damaged or malicious file exceeds: about a thousand times what a phone draws at ten
// frames a second.
constexpr std::size_t maxTriangles = std::size_t{1} << 30;
constexpr std::size_t maxInstances = std::size_t{1} << 22;

// True if the matrix has no inverse, because it flattens an object into a plane, a line or a point.
bool isFlattened(const glm::dmat4& matrix) {
    const glm::dvec3 x(matrix[0]);
    const glm::dvec3 y(matrix[1]);
    const glm::dvec3 z(matrix[2]);
    const double volume = std::abs(glm::dot(glm::cross(x, y), z));
    return !(volume > 1e-12 * glm::length(x) * glm::length(y) * glm::length(z));
}

// Loads meshes, one per primitive with triangles, when a node first needs them.
class MeshLoader {
  public:
    MeshLoader(GltfFile& file, Scene& scene, const std::vector<PlacedNode>& nodes)
        : file_(file), scene_(scene), materials_(file, scene), deformed_(file, nodes) {}

    // The mesh of one primitive.
    struct Part {
        Mesh mesh;            // kept only if skins or morph targets can deform it
        int asModelled = -1;  // index into Scene::meshes of the undeformed mesh; -1: not yet added
    };
    // Adds the meshes of a node to the scene. For a mesh that the node deforms it also adds the instance.
    // Returns the other meshes, which are shown as they are modelled.
    std::vector<int> add(const PlacedNode& placed) {
        std::vector<int> asModelled;
        for (Part& part : partsOf(placed.node->mesh)) {
            if (deformed_.deforms(placed, part.mesh)) {
                Instance instance{static_cast<int>(scene_.meshes.size())};
                scene_.meshes.push_back(deformed_.at(placed, part.mesh));
                instance.deforms = scene_.meshes.back().deformation != nullptr;
                scene_.instances.push_back(instance);
                continue;
            }
            if (part.asModelled < 0) {
                part.asModelled = static_cast<int>(scene_.meshes.size());
                scene_.meshes.push_back(part.mesh);
                scene_.meshes.back().deformation = nullptr;
            }
            asModelled.push_back(part.asModelled);
        }
        return asModelled;
    }

  private:
    std::vector<Part>& partsOf(int index) {
        const auto found = meshes_.find(index);
        if (found != meshes_.end()) return found->second;
        const tinygltf::Mesh& source = file_.at(file_.model.meshes, index, "mesh");
        std::vector<Part>& loaded = meshes_[index];
        const std::string name = "mesh " + indexAndName(static_cast<std::size_t>(index), source.name);
        for (const tinygltf::Primitive& primitive : source.primitives) {
            const std::optional<tinygltf::Primitive> unpacked = unpackDraco(file_, primitive, name);
            std::optional<Mesh> mesh = loadPrimitive(file_, unpacked ? *unpacked : primitive, materials_,
                                                     static_cast<std::size_t>(index));
            if (!mesh) continue;
            loaded.emplace_back();
            if (mesh->deformation != nullptr) {
                loaded.back().mesh = std::move(*mesh);
                continue;
            }
            loaded.back().asModelled = static_cast<int>(scene_.meshes.size());
            scene_.meshes.push_back(std::move(*mesh));
        }
        return loaded;
    }

    GltfFile& file_;
    Scene& scene_;
    MaterialLoader materials_;
    DeformedMeshes deformed_;
    std::map<int, std::vector<Part>> meshes_;
};

struct Placement {
    glm::dmat4 worldFromObject;
    int moving;  // see PlacedNode::moving
};

// Returns the placements of a node's mesh: one, or one for each instance of EXT_mesh_gpu_instancing. The
// instances of a moving node become nodes of the animation, as its children.
std::vector<Placement> placementsOf(GltfFile& file, const PlacedNode& placed, Animation& animation) {
    const std::optional<std::vector<NodeTransform>> instances = instancesIn(file, *placed.node);
    if (!instances) return {{placed.worldFromNode, placed.moving}};
    std::vector<Placement> placements;
    for (const NodeTransform& transform : *instances) {
        const glm::dmat4 worldFromObject = placed.worldFromNode * transform.parentFromNode();
        checkFinite(file, worldFromObject, *placed.node);
        placements.push_back({worldFromObject, placed.moving});
        if (placed.moving < 0) continue;
        placements.back().moving = static_cast<int>(animation.nodes.size());
        animation.nodes.push_back({placed.moving, glm::dmat4(1.0), transform});
    }
    return placements;
}

// Surfaces with little alpha are left out, so that light passes through panes. If the scene has no other
// surfaces, that would leave a black picture, so they are made opaque.
void keepSomethingVisible(GltfFile& file, Scene& scene) {
    const auto materialOf = [&](const Instance& instance) -> Material& {
        return scene.materials[scene.meshes[instance.mesh].material];
    };
    const auto isSeen = [&](const Instance& instance) {
        const Material& material = materialOf(instance);
        return material.alphaMode == Material::AlphaMode::opaque ||
               material.baseColor.a >= material.alphaCutoff;
    };
    if (std::any_of(scene.instances.begin(), scene.instances.end(), isSeen)) return;
    for (const Instance& instance : scene.instances)
        materialOf(instance).alphaMode = Material::AlphaMode::opaque;
    file.warn("the whole scene is nearly transparent, so it is drawn opaque");
}

// Multiplies all lengths of the file.
void scaleFile(GltfFile& file, double scale) {
    tinygltf::Node root;
    root.children = rootsOf(file);
    root.scale = {scale, scale, scale};
    file.model.nodes.push_back(std::move(root));
    file.model.scenes.assign(1, {});
    file.model.scenes.front().nodes = {static_cast<int>(file.model.nodes.size()) - 1};
    file.model.defaultScene = 0;
    for (tinygltf::Light& light : file.model.lights) {
        light.range *= scale;
        if (light.type != "directional") light.intensity *= scale * scale;
    }
    for (tinygltf::Camera& camera : file.model.cameras) {
        camera.perspective.znear *= scale;
        camera.orthographic.xmag *= scale;
        camera.orthographic.ymag *= scale;
    }
}

// Tells why nothing is left to draw.
[[noreturn]] void failWithoutTriangles(const GltfFile& file) {
    std::string what = "its scene has no triangles";
    if (!file.missingExtensions.empty())
        what += " without the extensions that it requires and vct does not know: " + file.missingExtensions;
    else if (!file.warnings.empty())
        what += " (" + listText(file.warnings) + ")";
    file.fail(what, "export it with a mesh");
}

Scene buildScene(GltfFile& file, const GltfOptions& options) {
    Scene scene;
    scene.path = file.path;
    std::size_t triangles = 0;
    if (options.scale != 1.0) scaleFile(file, options.scale);
    std::vector<PlacedNode> nodes = placeNodes(file);
    scene.animation = loadAnimation(file, options.animation, nodes);
    MeshLoader meshes(file, scene, nodes);
    const auto count = [&](std::size_t firstInstance) {
        for (std::size_t i = firstInstance; i < scene.instances.size(); ++i)
            triangles += scene.meshes[scene.instances[i].mesh].indices.size() / 3;
        if (triangles > maxTriangles || scene.instances.size() > maxInstances)
            file.fail("it has more triangles or instances than this program can draw", "simplify the scene");
    };
    for (const PlacedNode& placed : nodes) {
        if (!placed.isVisible) continue;
        addLight(file, placed, scene);
        if (placed.node->mesh == -1) continue;
        std::size_t first = scene.instances.size();
        const std::vector<int> parts = meshes.add(placed);
        count(first);
        if (parts.empty()) continue;  // without triangles, or with a skin, whose joints place it
        for (const Placement& place : placementsOf(file, placed, scene.animation)) {
            if (place.moving < 0 && isFlattened(place.worldFromObject)) {
                file.warn("nodes scaled to zero are left out");
                continue;
            }
            first = scene.instances.size();
            for (const int mesh : parts)
                scene.instances.push_back({mesh, place.worldFromObject, place.moving});
            count(first);
        }
    }
    if (scene.instances.empty()) failWithoutTriangles(file);
    keepSomethingVisible(file, scene);
    computeBounds(scene);
    const std::size_t lights = scene.punctualLights.size();
    const std::vector<std::string> leftOut = keepStrongestLights(scene, VCT_MAX_PUNCTUAL_LIGHTS);
    if (!leftOut.empty())
        file.warn(oneLine(file.path) + " has " + std::to_string(lights) +
                  " lights besides the sun, and the limit is " + std::to_string(VCT_MAX_PUNCTUAL_LIGHTS) +
                  "; those that give the least illuminance at the objects nearest to them are left out: " +
                  oneLine(listText(leftOut)));
    const std::vector<std::string> shadowless = lightsWithoutMaps(scene, VCT_MAX_LIGHT_MAPS);
    if (!shadowless.empty())
        file.warn(oneLine(file.path) + " has more lights than there are shadow maps (" +
                  std::to_string(VCT_MAX_LIGHT_MAPS) +
                  ", six for a point light); those that give the least illuminance at the objects nearest to "
                  "them cast no shadows: " +
                  oneLine(listText(shadowless)));
    addCameras(file, nodes, scene);
    scene.warnings = file.takeWarnings();
    return scene;
}

}  // namespace

std::vector<unsigned char> readFileFromDisk(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        throw Error("cannot read " + oneLine(path) + ": there is no such file; check the path");
    // A directory or a device has no size, and reading it may never end.
    if (!fs::is_regular_file(status))
        throw Error("cannot read " + oneLine(path) + ": it is not a file; check the path");
    const std::uintmax_t size = fs::file_size(path, error);
    std::ifstream stream(path, std::ios::binary);
    if (error || !stream)
        throw Error("cannot read " + oneLine(path) + ": access is denied; check its permissions");
    requireMainMemory(static_cast<std::size_t>(size), "the file " + oneLine(path), "use a smaller file");
    std::vector<unsigned char> bytes(static_cast<std::size_t>(size));
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(stream.gcount()) != size)
        throw Error("cannot read " + oneLine(path) + ": only a part of it could be read; copy it again");
    return bytes;
}

Scene loadGltf(const std::string& path, const ReadFile& readFile, const GltfOptions& options) {
    try {
        const std::vector<unsigned char> bytes = readFile(path);
        GltfFile file = openGltf(path, bytes, readFile, options.allowOutside);
        return buildScene(file, options);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw Error("cannot load " + oneLine(path) +
                    ": it needs more memory than is available; simplify the scene, or " + memoryRemedy());
    } catch (const std::exception& error) {
        throw Error("cannot load " + oneLine(path) + ": " + asClause(error.what()) + "; " + reexportRemedy);
    }
}

}  // namespace vct
