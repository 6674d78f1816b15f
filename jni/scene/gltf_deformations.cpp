#include "scene/gltf_deformations.h"

#include <algorithm>
#include <cmath>

#include "scene/gltf_accessors.h"

namespace vct {
namespace {

// Scales the weights to a sum of 1, which exporters meet only up to rounding. A vertex without weights
// follows its first joint.
void normalize(Influences& influences) {
    float sum = 0.0F;
    for (const float weight : influences.weights)
        sum += weight;
    if (!(sum > 0.0F)) {
        influences.weights = {1.0F, 0.0F, 0.0F, 0.0F};
        return;
    }
    for (float& weight : influences.weights)
        weight /= sum;
}

std::vector<Influences> loadInfluences(GltfFile& file, const tinygltf::Primitive& primitive,
                                       const VertexChoice& vertices) {
    const auto joints = primitive.attributes.find("JOINTS_0");
    const auto weights = primitive.attributes.find("WEIGHTS_0");
    if (joints == primitive.attributes.end() || weights == primitive.attributes.end()) return {};
    if (primitive.attributes.count("JOINTS_1") != 0)
        file.warn("vertices follow more than four joints; only the first four are used");
    const std::vector<float> indices =
        readVertexFloats(file, joints->second, 4, Components::anySmallInteger, "JOINTS_0", vertices);
    const std::vector<float> shares = readVertexFloats(
        file, weights->second, 4, Components::floatOrNormalizedUnsigned, "WEIGHTS_0", vertices);
    const std::size_t vertexCount = vertices.count();
    file.reserveGeometry(vertexCount, sizeof(Influences));
    std::vector<Influences> influences(vertexCount);
    for (std::size_t vertex = 0; vertex < vertexCount; ++vertex) {
        for (std::size_t i = 0; i < 4; ++i) {
            const float weight = shares[vertex * 4 + i];
            const float joint = indices[vertex * 4 + i];
            const bool usable = weight >= 0.0F && weight <= 1e6F;  // false for NaN
            if (!usable) file.warn("weights of joints that are not usable numbers are taken as 0");
            influences[vertex].weights[i] = usable ? weight : 0.0F;
            if (joint >= 0.0F && joint <= 65535.0F)
                influences[vertex].joints[i] = static_cast<std::uint16_t>(joint);
        }
        normalize(influences[vertex]);
    }
    return influences;
}

// False if an element is NaN or too large for sums.
bool isUsable(const glm::dmat4& matrix) {
    const double* const first = &matrix[0][0];
    return std::all_of(first, first + 16, [](double value) { return std::abs(value) <= 1e30; });
}

// Returns one displacement per vertex, or none if the target has no such attribute.
std::vector<glm::vec3> loadDisplacements(GltfFile& file, const std::map<std::string, int>& target,
                                         const char* attribute, const VertexChoice& vertices) {
    const auto found = target.find(attribute);
    if (found == target.end()) return {};
    const Components components = file.isQuantized ? Components::anySmallInteger : Components::floatOnly;
    const std::vector<float> values = readVertexFloats(
        file, found->second, 3, components, std::string("the ") + attribute + " of a morph target", vertices);
    file.reserveGeometry(vertices.count(), sizeof(glm::vec3));
    std::vector<glm::vec3> displacements(vertices.count());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool usable = std::abs(values[i]) <= 1e30F;  // false for NaN
        if (!usable) file.warn("displacements of morph targets that are not usable numbers are taken as 0");
        displacements[i / 3][static_cast<int>(i % 3)] = usable ? values[i] : 0.0F;
    }
    return displacements;
}

}  // namespace

std::shared_ptr<Deformation> loadDeformation(GltfFile& file, const tinygltf::Primitive& primitive,
                                             const VertexChoice& vertices) {
    auto deformation = std::make_shared<Deformation>();
    deformation->influences = loadInfluences(file, primitive, vertices);
    for (const std::map<std::string, int>& target : primitive.targets) {
        MorphTarget loaded{loadDisplacements(file, target, "POSITION", vertices),
                           loadDisplacements(file, target, "NORMAL", vertices)};
        if (loaded.positions.empty()) {
            file.reserveGeometry(vertices.count(), sizeof(glm::vec3));
            loaded.positions.resize(vertices.count());
        }
        deformation->targets.push_back(std::move(loaded));
    }
    if (deformation->influences.empty() && deformation->targets.empty()) return nullptr;
    return deformation;
}

DeformedMeshes::DeformedMeshes(GltfFile& file, const std::vector<PlacedNode>& nodes) : file_(file) {
    for (const PlacedNode& placed : nodes)
        placedOf_[static_cast<int>(placed.node - file.model.nodes.data())] = &placed;
}

bool DeformedMeshes::deforms(const PlacedNode& placed, const Mesh& mesh) const {
    if (mesh.deformation == nullptr) return false;
    if (placed.node->skin >= 0 && !mesh.deformation->influences.empty()) return true;
    if (mesh.deformation->targets.empty()) return false;
    const std::vector<float> weights = morphWeightsAtRest(file_, *placed.node);
    return placed.morph >= 0 ||
           std::any_of(weights.begin(), weights.end(), [](float weight) { return weight != 0.0F; });
}

const std::vector<Joint>& DeformedMeshes::jointsOf(int skin) {
    const auto found = skins_.find(skin);
    if (found != skins_.end()) return found->second;
    const tinygltf::Skin& source = file_.at(file_.model.skins, skin, "skin");
    const std::string name = "skin " + indexAndName(static_cast<std::size_t>(skin), source.name);
    if (source.joints.empty()) file_.fail(name + " has no joints");
    std::vector<Joint> joints(source.joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
        file_.at(file_.model.nodes, source.joints[i], "node");
        const auto placed = placedOf_.find(source.joints[i]);
        if (placed == placedOf_.end()) {
            file_.warn("joints of skins that are not in the scene stay at the world's origin");
            continue;
        }
        joints[i].node = placed->second->moving;
        joints[i].worldFromJoint = placed->second->worldFromNode;
    }
    if (source.inverseBindMatrices >= 0) {
        const std::string what = name + ", its inverse bind matrices";
        const std::vector<float> values =
            readFloats(file_, source.inverseBindMatrices, 16, Components::floatOnly, what);
        if (values.size() < joints.size() * 16)
            file_.fail(what + " are only " + std::to_string(values.size() / 16) + " for " +
                       std::to_string(joints.size()) + " joints");
        for (std::size_t i = 0; i < joints.size(); ++i)
            for (std::size_t k = 0; k < 16; ++k)
                joints[i].jointFromObject[static_cast<int>(k / 4)][static_cast<int>(k % 4)] =
                    values[i * 16 + k];
    }
    return skins_.emplace(skin, std::move(joints)).first->second;
}

void DeformedMeshes::checkFollowed(int skin, Deformation& deformation) const {
    std::vector<bool> isFollowed(deformation.joints.size());
    for (const Influences& influences : deformation.influences)
        for (std::size_t i = 0; i < 4; ++i)
            if (influences.weights[i] != 0.0F) isFollowed[influences.joints[i]] = true;
    for (std::size_t i = 0; i < deformation.joints.size(); ++i) {
        glm::dmat4& matrix = deformation.joints[i].jointFromObject;
        if (!isFollowed[i])
            matrix = glm::dmat4(1.0);
        else if (!isUsable(matrix))
            file_.fail(
                "skin " +
                indexAndName(static_cast<std::size_t>(skin), file_.at(file_.model.skins, skin, "skin").name) +
                " has an inverse bind matrix, of joint " + std::to_string(i) +
                ", that is not usable numbers");
    }
}

Mesh DeformedMeshes::at(const PlacedNode& placed, const Mesh& mesh) {
    auto deformation = std::make_shared<Deformation>(*mesh.deformation);
    const std::size_t count = mesh.vertices.size();
    file_.reserveGeometry(count, sizeof(Vertex) + sizeof(VertexExtras) + 2 * sizeof(glm::vec3) +
                                     sizeof(Influences) +
                                     deformation->targets.size() * sizeof(glm::vec3) * 2);
    file_.reserveGeometry(mesh.indices.size(), sizeof(std::uint32_t));
    const bool skinned = placed.node->skin >= 0 && !deformation->influences.empty();
    if (skinned) {
        deformation->joints = jointsOf(placed.node->skin);
        for (Influences& influences : deformation->influences)
            for (std::size_t i = 0; i < 4; ++i) {
                if (influences.weights[i] == 0.0F) influences.joints[i] = 0;
                if (influences.joints[i] >= deformation->joints.size())
                    file_.fail("mesh \"" + oneLine(mesh.name) + "\" has vertices that follow joint " +
                               std::to_string(influences.joints[i]) + " of " +
                               std::to_string(deformation->joints.size()));
            }
        checkFollowed(placed.node->skin, *deformation);
    } else {
        deformation->influences.clear();
        deformation->joints = {{placed.moving, placed.worldFromNode, glm::dmat4(1.0)}};
    }
    deformation->morph = deformation->targets.empty() ? -1 : placed.morph;
    deformation->weights = morphWeightsAtRest(file_, *placed.node);
    deformation->centre = mesh.centre;
    for (const Vertex& vertex : mesh.vertices) {
        deformation->positions.push_back(vertex.position);
        deformation->normals.push_back(vertex.normal);
    }

    Mesh result = mesh;
    const DeformationState rest = stateOf(*deformation, nullptr);
    std::vector<DeformedVertex> vertices;
    vertices.reserve(count);
    Bounds bounds = noBounds;
    for (std::size_t i = 0; i < count; ++i)
        vertices.push_back(deformedVertex(*deformation, rest, i));
    for (const std::uint32_t index : mesh.indices)
        bounds.include(vertices[index].positionWorld);
    result.centre = 0.5 * (bounds.min + bounds.max);
    for (std::size_t i = 0; i < count; ++i) {
        result.vertices[i].position = glm::vec3(vertices[i].positionWorld - result.centre);
        if (vertices[i].normalWorld != glm::dvec3(0.0))
            result.vertices[i].normal = glm::vec3(vertices[i].normalWorld);
    }
    // The triangles' winding is that of the undeformed mesh, and the instance has no matrix that could mirror
    // it.
    if (isMirrored(rest))
        for (std::size_t i = 0; i + 2 < result.indices.size(); i += 3)
            std::swap(result.indices[i + 1], result.indices[i + 2]);
    result.deformation = deformation->moves() ? deformation : nullptr;
    return result;
}

}  // namespace vct
