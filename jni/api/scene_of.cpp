#include "api/scene_of.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/error.h"
#include "scene/gltf.h"
#include "shared/layout.h"

namespace vct {

namespace {

// The square of a larger coordinate would exceed the range of float. Scenes from files have the same limit.
constexpr double maxCoordinate = 1e18;

void require(bool ok, const std::string& message) {
    if (!ok) throw Error(message);
}

std::string indexed(const char* what, std::size_t index) {
    return what + (" " + std::to_string(index));
}

// True if all numbers are within the range, which NaN never is.
template <class Numbers>
bool within(const Numbers& numbers, double least, double most) {
    return std::all_of(std::begin(numbers), std::end(numbers),
                       [&](auto number) { return number >= least && number <= most; });
}

glm::vec3 color(const std::array<float, 3>& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

glm::dvec3 vectorAt(std::span<const float> numbers, std::uint32_t vertex) {
    const float* v = &numbers[std::size_t{3} * vertex];
    return {v[0], v[1], v[2]};
}

// Returns the index of the GL texture in `textures`, and adds it if it is not there yet; -1 for none.
int textureOf(unsigned name, std::vector<Texture>& textures) {
    if (name == 0) return -1;
    const auto found = std::find_if(textures.begin(), textures.end(),
                                    [&](const Texture& texture) { return texture.external == name; });
    if (found != textures.end()) return static_cast<int>(found - textures.begin());
    auto free = std::find_if(textures.begin(), textures.end(),
                             [](const Texture& texture) { return texture.external == 0; });
    if (free == textures.end()) free = textures.emplace(free);
    free->external = name;
    return static_cast<int>(free - textures.begin());
}

// `material`: that of the mesh.
void addAttributes(const MeshDescription& description, const Material& material, Mesh& mesh) {
    const std::size_t vertices = mesh.vertices.size();
    const std::span<const float> uv = description.textureCoordinates, colors = description.colors;
    const bool isTextured = hasTextures(material);
    require(uv.size() == 2 * vertices || (uv.empty() && !isTextured),
            mesh.name + ": it has " + std::to_string(uv.size()) + " numbers of texture coordinates for " +
                std::to_string(vertices) + " vertices; give two per vertex, as its material has textures");
    require(colors.empty() || colors.size() == 4 * vertices,
            mesh.name + ": it has " + std::to_string(colors.size()) + " numbers of colours for " +
                std::to_string(vertices) + " vertices; give four per vertex, or none");
    require(within(colors, 0.0, 1.0), mesh.name + ": give colours between 0 and 1");
    if (!uv.empty()) {
        require(within(uv, -1e6, 1e6), mesh.name + ": give texture coordinates between -1e6 and 1e6");
        for (std::size_t i = 0; i < vertices; ++i)
            mesh.vertices[i].uv = mesh.vertices[i].emissiveUv = {uv[2 * i], uv[2 * i + 1]};
    }
    if (colors.empty() && material.glossTexture < 0 && material.normalTexture < 0) return;
    mesh.extras.resize(vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
        VertexExtras& extras = mesh.extras[i];
        if (!colors.empty())
            extras.color = {colors[4 * i], colors[4 * i + 1], colors[4 * i + 2], colors[4 * i + 3]};
        if (!uv.empty()) extras.glossUv = extras.normalUv = {uv[2 * i], uv[2 * i + 1]};
    }
}

// The mesh gets a single joint, the node of its instance.
void makeDeforming(Scene& scene, std::size_t index) {
    Mesh& mesh = scene.meshes[index];
    Instance* only = nullptr;
    std::size_t count = 0;
    for (Instance& instance : scene.instances)
        if (instance.mesh == static_cast<int>(index)) {
            only = &instance;
            ++count;
        }
    require(count == 1 && only->node >= 0,
            mesh.name + ": it has `deforms`; give it exactly one instance, with `moves`");
    auto deformation = std::make_shared<Deformation>();
    deformation->centre = mesh.centre;
    for (const Vertex& vertex : mesh.vertices) {
        deformation->positions.push_back(vertex.position);
        deformation->normals.push_back(vertex.normal);
    }
    deformation->joints = {{only->node, only->worldFromObject, glm::dmat4(1.0)}};
    mesh.deformation = std::move(deformation);
    only->deforms = true;
}

}  // namespace

bool hasTextures(const Material& material) {
    return material.baseColorTexture >= 0 || material.emissiveTexture >= 0 || material.glossTexture >= 0 ||
           material.normalTexture >= 0;
}

Material materialOf(const MaterialDescription& description, const std::string& name,
                    std::vector<Texture>& textures) {
    require(within(description.baseColor, 0.0, 1.0), name + ": give a base colour between 0 and 1");
    require(within(description.emission, 0.0, 1e30), name + ": give an emission between 0 and 1e30");
    const float surface[] = {description.metallic, description.roughness};
    require(within(surface, 0.0, 1.0), name + ": give metallic and roughness between 0 and 1");
    Material material;
    material.name = name;
    material.baseColor = glm::vec4(color(description.baseColor), 1.0F);
    material.emissive = color(description.emission);
    material.metallic = description.metallic;
    material.roughness = description.roughness;
    material.doubleSided = description.doubleSided;
    const float cutoff[] = {description.alphaCutoff};
    require(within(cutoff, 0.0, 1.0), name + ": give an alpha cutoff between 0 and 1");
    if (description.alphaCutoff > 0.0F) material.alphaMode = Material::AlphaMode::mask;
    material.alphaCutoff = description.alphaCutoff;
    material.baseColorTexture = textureOf(description.baseColorTexture, textures);
    material.emissiveTexture = textureOf(description.emissionTexture, textures);
    material.glossTexture = textureOf(description.glossTexture, textures);
    material.normalTexture = textureOf(description.normalTexture, textures);
    const float scale[] = {description.normalScale};
    require(within(scale, -1e6, 1e6), name + ": give a normalScale between -1e6 and 1e6");
    material.normalScale = description.normalScale;
    return material;
}

Mesh meshOf(const MeshDescription& description, const Material& material, const std::string& name) {
    const std::size_t vertices = description.positions.size() / 3;
    require(description.positions.size() % 3 == 0 && vertices <= 0xFFFFFFFFU,
            name + ": give three numbers per position, and at most 2^32 vertices");
    require(description.normals.size() == description.positions.size(),
            name + ": its normals have " + std::to_string(description.normals.size()) +
                " numbers and its positions " + std::to_string(description.positions.size()) +
                "; give as many normals as positions");
    require(!description.indices.empty() && description.indices.size() % 3 == 0,
            name + ": it has " + std::to_string(description.indices.size()) +
                " indices; give three per triangle, and at least one triangle");
    Mesh mesh;
    mesh.name = name;
    mesh.material = static_cast<int>(description.material);
    mesh.indices.assign(description.indices.begin(), description.indices.end());
    Bounds bounds = noBounds;
    for (const std::uint32_t index : mesh.indices) {
        require(index < vertices, name + ": an index is " + std::to_string(index) + ", but the mesh has " +
                                      std::to_string(vertices) + " vertices");
        const glm::dvec3 position = vectorAt(description.positions, index);
        const double numbers[] = {position.x, position.y, position.z};
        require(within(numbers, -maxCoordinate, maxCoordinate),
                name + ": the position of vertex " + std::to_string(index) + " is not finite or beyond 1e18");
        bounds.include(position);
    }
    mesh.centre = 0.5 * (bounds.min + bounds.max);
    mesh.vertices.resize(vertices);
    // Only vertices in use are checked.
    for (const std::uint32_t index : mesh.indices) {
        const glm::dvec3 normal = vectorAt(description.normals, index);
        const double length = std::sqrt(glm::dot(normal, normal));
        require(length > 0.0 && std::isfinite(length),
                name + ": the normal of vertex " + std::to_string(index) + " has no direction");
        mesh.vertices[index].position = glm::vec3(vectorAt(description.positions, index) - mesh.centre);
        mesh.vertices[index].normal = glm::vec3(normal / length);
    }
    addAttributes(description, material, mesh);
    return mesh;
}

DirectionalLight lightOf(const Sun& sun) {
    DirectionalLight light;
    light.directionToLight = direction(sun.directionToSun, "the direction towards the sun");
    require(within(sun.color, 0.0, 1.0) && *std::max_element(sun.color.begin(), sun.color.end()) == 1.0F,
            "the sun's colour: give three numbers between 0 and 1, the largest of them 1");
    const float illuminance[] = {sun.illuminance};
    require(within(illuminance, 0.0, 1e30), "the sun's illuminance: give a number between 0 and 1e30");
    light.color = color(sun.color);
    light.intensity = sun.illuminance;
    return light;
}

PunctualLight lightOf(const LightDescription& description, const std::string& name) {
    using Type = LightDescription::Type;
    PunctualLight light;
    const bool isDirectional = description.type == Type::directional;
    light.type = isDirectional                    ? PunctualLight::Type::directional
                 : description.type == Type::spot ? PunctualLight::Type::spot
                                                  : PunctualLight::Type::point;
    require(within(description.color, 0.0, 1.0), name + ": give a colour between 0 and 1");
    const float intensity[] = {description.intensity};
    require(within(intensity, 0.0, 1e30), name + ": give an intensity between 0 and 1e30");
    require(within(description.position, -maxCoordinate, maxCoordinate),
            name + ": its position has a number that is not finite or beyond 1e18");
    require(description.range > 0.0F, name + ": give a range above 0");
    require(description.radius >= 0.0F && std::isfinite(description.radius),
            name + ": give a radius of 0 or above");
    require(description.diameterDegrees >= 0.0F && description.diameterDegrees <= 170.0F,
            name + ": give a diameter between 0 and 170 degrees");
    require(description.innerConeDegrees >= 0.0F &&
                description.innerConeDegrees < description.outerConeDegrees &&
                description.outerConeDegrees <= 90.0F,
            name + ": give cone angles with 0 <= inner < outer <= 90 degrees");
    const float largest = *std::max_element(description.color.begin(), description.color.end());
    light.color = largest > 0.0F ? color(description.color) / largest : glm::vec3(0.0F);
    light.intensity = description.intensity * largest;
    if (light.type != PunctualLight::Type::point) {
        const glm::dvec3 backwards = -direction(description.direction, name + ": its direction");
        const glm::dvec3 helper = std::abs(backwards.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
        const glm::dvec3 right = glm::normalize(glm::cross(helper, backwards));
        light.worldFromLight[0] = glm::dvec4(right, 0.0);
        light.worldFromLight[1] = glm::dvec4(glm::cross(backwards, right), 0.0);
        light.worldFromLight[2] = glm::dvec4(backwards, 0.0);
    }
    light.worldFromLight[3] = {description.position[0], description.position[1], description.position[2],
                               1.0};
    if (!isDirectional) light.range = description.range;
    light.innerConeRad = glm::radians(double{description.innerConeDegrees});
    light.outerConeRad = glm::radians(double{description.outerConeDegrees});
    light.size = isDirectional ? std::tan(0.5 * glm::radians(double{description.diameterDegrees}))
                               : double{description.radius};
    return light;
}

glm::dmat4 affine(const Matrix& matrix, const std::string& what) {
    glm::dmat4 result;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            result[column][row] = matrix.columns[4 * column + row];
    require(within(matrix.columns, -maxCoordinate, maxCoordinate),
            what + " has a number that is not finite or beyond 1e18");
    require(result[0][3] == 0.0 && result[1][3] == 0.0 && result[2][3] == 0.0 && result[3][3] == 1.0,
            what + " is not affine: its last row must be 0 0 0 1 (and matrices are in column-major order)");
    return result;
}

glm::dvec3 direction(const std::array<double, 3>& vector, const std::string& what) {
    const glm::dvec3 v(vector[0], vector[1], vector[2]);
    const double length = glm::length(v);
    require(length > 0.0 && std::isfinite(length), what + " has no length, or is not finite");
    return v / length;
}

Scene sceneOf(const SceneDescription& description) {
    Scene scene;
    scene.path = "described by the program";
    for (const MaterialDescription& material : description.materials)
        scene.materials.push_back(
            materialOf(material, indexed("material", scene.materials.size()), scene.textures));
    for (const MeshDescription& mesh : description.meshes) {
        const std::string name = indexed("mesh", scene.meshes.size());
        require(mesh.material < scene.materials.size(),
                name + ": there is no material " + std::to_string(mesh.material) + "; the scene has " +
                    std::to_string(scene.materials.size()) + " materials");
        scene.meshes.push_back(meshOf(mesh, scene.materials[mesh.material], name));
        scene.materials[mesh.material].vertexColors |= !mesh.colors.empty();
    }
    for (Mesh& mesh : scene.meshes)
        if (scene.materials[static_cast<std::size_t>(mesh.material)].vertexColors)
            mesh.extras.resize(mesh.vertices.size());
    int movers = 0;
    for (const InstanceDescription& instance : description.instances) {
        const std::string name = indexed("instance", scene.instances.size());
        require(instance.mesh < scene.meshes.size(), name + ": there is no mesh " +
                                                         std::to_string(instance.mesh) + "; the scene has " +
                                                         std::to_string(scene.meshes.size()) + " meshes");
        scene.instances.push_back({static_cast<int>(instance.mesh),
                                   affine(instance.worldFromObject, "the transform of " + name),
                                   instance.moves ? movers++ : -1});
    }
    for (std::size_t i = 0; i < scene.meshes.size(); ++i)
        if (description.meshes[i].deforms) makeDeforming(scene, i);
    // Each takes uniforms, from the beginning.
    constexpr std::size_t mostInstances = std::size_t{1} << 20;
    require(description.maxInstances <= mostInstances,
            "SceneDescription::maxInstances must be at most " + std::to_string(mostInstances));
    require(description.maxInstances == 0 || description.maxInstances >= description.instances.size(),
            "SceneDescription::maxInstances is " + std::to_string(description.maxInstances) +
                ", and the scene has " + std::to_string(description.instances.size()) +
                " instances; count them too");
    const std::size_t room = std::max(description.maxInstances, description.instances.size());
    scene.instanceRoom = room - description.instances.size();
    scene.materialsChange = true;
    require(!scene.instances.empty(), "the scene has no instances; give it at least one");
    scene.lights.push_back(lightOf(description.sun));
    for (const LightDescription& light : description.lights)
        scene.punctualLights.push_back(lightOf(light, indexed("light", scene.punctualLights.size())));
    const std::size_t lights = std::max(description.lights.size(), description.maxLights);
    require(lights <= VCT_MAX_PUNCTUAL_LIGHTS,
            "the scene may have " + std::to_string(lights) + " lights, and the limit is " +
                std::to_string(VCT_MAX_PUNCTUAL_LIGHTS) + "; leave out the weakest");
    scene.punctualLightRoom = lights - description.lights.size();
    computeBounds(scene);
    if (description.bounds) {
        const auto& [min, max] = *description.bounds;
        require(within(min, -maxCoordinate, maxCoordinate) && within(max, -maxCoordinate, maxCoordinate) &&
                    min[0] <= max[0] && min[1] <= max[1] && min[2] <= max[2],
                "the scene's bounds: give finite numbers, and no component of max below that of min");
        scene.boundsWorld.include({min[0], min[1], min[2]});
        scene.boundsWorld.include({max[0], max[1], max[2]});
    }
    return scene;
}

}  // namespace vct
