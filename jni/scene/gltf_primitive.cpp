// Loads a primitive of a glTF mesh: its vertices and triangles (declared in gltf_materials.h).
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "scene/gltf_accessors.h"
#include "scene/gltf_deformations.h"
#include "scene/gltf_materials.h"

namespace vct {
namespace {

using Indices = std::vector<std::uint32_t>;

// A mesh with a larger extent is taken for a damaged file.
constexpr double maxExtent = 1e30;

// Converts strips and fans to lists and keeps the winding (glTF 2.0 section 3.7.2.1).
Indices triangleList(GltfFile& file, int mode, Indices corners) {
    const std::size_t count = corners.size();
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        if (count % 3 != 0)
            file.warn("a list of triangles ends with an incomplete triangle, which is left out");
        corners.resize(count / 3 * 3);
        return corners;
    }
    Indices list;
    if (count < 3) return list;
    file.reserveGeometry((count - 2) * 3, sizeof(std::uint32_t));
    list.reserve((count - 2) * 3);
    for (std::size_t i = 0; i + 2 < count; ++i) {
        const bool strip = mode == TINYGLTF_MODE_TRIANGLE_STRIP;
        const std::size_t odd = i % 2;
        list.push_back(strip ? corners[i] : corners[0]);
        list.push_back(strip ? corners[i + 1 + odd] : corners[i + 1]);
        list.push_back(strip ? corners[i + 2 - odd] : corners[i + 2]);
    }
    return list;
}

glm::dvec3 position(const std::vector<float>& values, std::uint32_t vertex) {
    const float* p = &values[std::size_t{3} * vertex];
    return {p[0], p[1], p[2]};
}

Bounds usedBounds(const GltfFile& file, const std::vector<float>& positions, const Indices& indices,
                  const std::string& mesh) {
    Bounds bounds = noBounds;
    for (const std::uint32_t index : indices) {
        const glm::dvec3 p = position(positions, index);
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            file.fail(mesh + " has a position that is not a finite number");
        bounds.include(p);
    }
    const glm::dvec3 extent = bounds.max - bounds.min;
    if (!(extent.x <= maxExtent && extent.y <= maxExtent && extent.z <= maxExtent))
        file.fail(mesh + " has positions further apart than 1e30", "scale it down");
    return bounds;
}

// Returns the vector with unit length, or `fallback` if it has no direction.
glm::vec3 unitOr(const glm::dvec3& v, const glm::vec3& fallback) {
    const double length = std::sqrt(glm::dot(v, v));
    return length > 0.0 && std::isfinite(length) ? glm::vec3(v / length) : fallback;
}

// Returns the normal times twice the area. In double the products of float differences cannot overflow or
// vanish.
glm::dvec3 areaNormal(const Mesh& mesh, std::size_t firstIndex) {
    const auto corner = [&](std::size_t i) {
        return glm::dvec3(mesh.vertices[mesh.indices[firstIndex + i]].position);
    };
    return glm::cross(corner(1) - corner(0), corner(2) - corner(0));
}

const glm::vec3 degenerateNormal{0.0F, 1.0F, 0.0F};  // for triangles without area, which are invisible

// Gives a mesh without normals flat ones (glTF 2.0 section 3.7.2.1), so each triangle gets its own vertices.
// In a deformed mesh these normals turn with the joints, but morph targets do not change them.
void makeFlat(GltfFile& file, Mesh& mesh, Deformation* deformation) {
    const auto split = [&](auto& vertexValues) {
        if (vertexValues.empty()) return;
        using Element = typename std::decay_t<decltype(vertexValues)>::value_type;
        file.reserveGeometry(mesh.indices.size(), sizeof(Element));
        std::vector<Element> cornerValues;
        cornerValues.reserve(mesh.indices.size());
        for (const std::uint32_t index : mesh.indices)
            cornerValues.push_back(vertexValues[index]);
        vertexValues = std::move(cornerValues);
    };
    if (deformation != nullptr) {
        split(deformation->influences);
        for (MorphTarget& target : deformation->targets) {
            split(target.positions);
            target.normals.clear();  // displacements of normals make no sense without normals in the file
        }
    }
    split(mesh.extras);
    split(mesh.vertices);
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0U);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 normal = unitOr(areaNormal(mesh, i), degenerateNormal);
        for (std::size_t corner = 0; corner < 3; ++corner)
            mesh.vertices[i + corner].normal = normal;
    }
}

// Sets normals of unit length. If one of the file has no direction, it is computed from the faces around the
// vertex.
void setNormals(GltfFile& file, Mesh& mesh, const std::vector<float>& normals) {
    std::vector<bool> bad(mesh.vertices.size());
    bool anyBad = false;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const float* n = &normals[i * 3];
        const glm::dvec3 normal(n[0], n[1], n[2]);
        const double length2 = glm::dot(normal, normal);
        // Exporters write normals of unit length. A length below a thousandth is rounding noise, not a
        // direction.
        bad[i] = !(length2 > 1e-6 && std::isfinite(length2));
        anyBad = anyBad || bad[i];
        mesh.vertices[i].normal = bad[i] ? degenerateNormal : unitOr(normal, degenerateNormal);
    }
    if (!anyBad) return;

    std::vector<glm::dvec3> sums(mesh.vertices.size(), glm::dvec3(0.0));
    bool usedBad = false;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 normal = areaNormal(mesh, i);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            sums[mesh.indices[i + corner]] += normal;
            usedBad = usedBad || bad[mesh.indices[i + corner]];
        }
    }
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        if (bad[i]) mesh.vertices[i].normal = unitOr(sums[i], degenerateNormal);
    }
    if (usedBad) file.warn("normals without a direction are replaced by those of their faces");
}

// Returns the attribute's accessor, or -1 if the primitive has no such attribute.
int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

template <class Holder>
void setUv(GltfFile& file, const tinygltf::Primitive& primitive, const UvSource& source,
           const VertexChoice& vertices, std::vector<Holder>& holders, glm::vec2 Holder::* member) {
    const std::string name = "TEXCOORD_" + std::to_string(source.texCoord);
    const int accessor = attribute(primitive, name);
    if (accessor == -1) {
        if (source.hasTexture)
            file.warn("a textured mesh has no " + name + ", so one texel of its texture covers it");
        return;
    }
    const Components components =
        file.isQuantized ? Components::anySmallInteger : Components::floatOrNormalizedUnsigned;
    const std::vector<float> values = readVertexFloats(file, accessor, 2, components, name, vertices);
    for (std::size_t i = 0; i < holders.size(); ++i) {
        const glm::vec2 uv(values[i * 2], values[i * 2 + 1]);
        const bool usable = std::abs(uv.x) <= 1e9F && std::abs(uv.y) <= 1e9F;  // false for NaN
        if (!usable) file.warn("texture coordinates that are not usable numbers are taken as 0");
        holders[i].*member = source(usable ? uv : glm::vec2(0.0F));
    }
}

void setColors(GltfFile& file, Mesh& mesh, int accessor, const VertexChoice& vertices) {
    const int width = file.at(file.model.accessors, accessor, "accessor").type == TINYGLTF_TYPE_VEC3 ? 3 : 4;
    const std::vector<float> values =
        readVertexFloats(file, accessor, width, Components::floatOrNormalizedUnsigned, "COLOR_0", vertices);
    for (std::size_t i = 0; i < mesh.extras.size(); ++i)
        for (int c = 0; c < width; ++c) {
            const float value = values[i * static_cast<std::size_t>(width) + static_cast<std::size_t>(c)];
            if (!std::isfinite(value)) file.warn("vertex colours that are not usable numbers are taken as 1");
            mesh.extras[i].color[c] = std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 1.0F;
        }
}

}  // namespace

std::optional<Mesh> loadPrimitive(GltfFile& file, const tinygltf::Primitive& primitive,
                                  MaterialLoader& materials, std::size_t meshIndex) {
    const std::string& meshName = file.model.meshes[meshIndex].name;
    const std::string label = "mesh " + indexAndName(meshIndex, meshName);
    if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
        file.fail(label + " has the unknown mode " + std::to_string(primitive.mode));
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
        file.warn("points and lines are left out");
        return std::nullopt;
    }

    const int positionAccessor = attribute(primitive, "POSITION");
    if (positionAccessor == -1) {
        file.warn("a mesh without positions is left out");
        return std::nullopt;
    }
    VertexChoice vertices{file.at(file.model.accessors, positionAccessor, "accessor").count, {}};
    if (vertices.declared > std::numeric_limits<std::uint32_t>::max())
        file.fail("accessor " + std::to_string(positionAccessor) + " (POSITION) has more than 2^32 elements");

    Indices corners;
    if (primitive.indices != -1) {
        corners = readIndices(file, primitive.indices, vertices.declared);
        vertices = chooseVertices(vertices.declared, corners);
    } else {
        file.reserveGeometry(vertices.declared, sizeof(std::uint32_t));
        corners.resize(vertices.declared);
        std::iota(corners.begin(), corners.end(), 0U);
    }
    const std::size_t vertexCount = vertices.count();
    const Components components = file.isQuantized ? Components::anySmallInteger : Components::floatOnly;
    const std::vector<float> positions =
        readVertexFloats(file, positionAccessor, 3, components, "POSITION", vertices);

    Mesh mesh;
    mesh.name = meshName.empty() ? label : meshName;
    mesh.indices = triangleList(file, primitive.mode, std::move(corners));
    if (mesh.indices.empty()) return std::nullopt;

    const int colorAccessor = attribute(primitive, "COLOR_0");
    const MaterialUse& material = materials.get(primitive.material, colorAccessor != -1);
    mesh.material = material.material;
    const Bounds bounds = usedBounds(file, positions, mesh.indices, label);
    mesh.centre = 0.5 * (bounds.min + bounds.max);
    file.reserveGeometry(vertexCount, sizeof(Vertex));
    mesh.vertices.assign(vertexCount,
                         Vertex{glm::vec3(0.0F), degenerateNormal, glm::vec2(0.0F), glm::vec2(0.0F)});
    // Unused vertices may hold any values, so they stay at the centre.
    for (const std::uint32_t index : mesh.indices)
        mesh.vertices[index].position = glm::vec3(position(positions, index) - mesh.centre);

    setUv(file, primitive, material.baseColor, vertices, mesh.vertices, &Vertex::uv);
    setUv(file, primitive, material.emissive, vertices, mesh.vertices, &Vertex::emissiveUv);
    if (colorAccessor != -1 || material.gloss.hasTexture || material.normal.hasTexture) {
        file.reserveGeometry(vertexCount, sizeof(VertexExtras));
        mesh.extras.resize(vertexCount);
        setUv(file, primitive, material.gloss, vertices, mesh.extras, &VertexExtras::glossUv);
        setUv(file, primitive, material.normal, vertices, mesh.extras, &VertexExtras::normalUv);
        if (colorAccessor != -1) setColors(file, mesh, colorAccessor, vertices);
    }

    const std::shared_ptr<Deformation> deformation = loadDeformation(file, primitive, vertices);
    const int normalAccessor = attribute(primitive, "NORMAL");
    if (normalAccessor == -1) {
        makeFlat(file, mesh, deformation.get());
    } else {
        setNormals(file, mesh, readVertexFloats(file, normalAccessor, 3, components, "NORMAL", vertices));
    }
    mesh.deformation = deformation;
    return mesh;
}

}  // namespace vct
