// Materials, meshes and instances that are added, changed and removed while a program runs.
#include <algorithm>

#include "api/caller_objects.h"
#include "api/implementation.h"
#include "api/saved_state.h"
#include "api/scene_of.h"
#include "core/list_text.h"
#include "core/number_text.h"

namespace vct {

namespace {

// The first number of at least `first` that is free, or a new one.
template <class States, class IsFree>
std::size_t freeNumber(const States& states, std::size_t first, const IsFree& isFree) {
    for (std::size_t i = first; i < states.size(); ++i)
        if (isFree(states[i])) return i;
    return states.size();
}

// For a message: "double-sided, emission".
std::string kindText(unsigned features) {
    std::vector<std::string> words{features & featureDoubleSided ? "double-sided" : "single-sided"};
    for (const auto& [feature, word] : {std::pair{featureBaseColorTexture, "a texture of base colour"},
                                        {featureAlphaMask, "an alpha cutoff"},
                                        {featureVertexColors, "vertex colours"},
                                        {featureEmissive, "emission"},
                                        {featureEmissiveTexture, "a texture of emission"},
                                        {featureGlossTexture, "a gloss texture"},
                                        {featureNormalMap, "a normal map"}})
        if (features & feature) words.emplace_back(word);
    return listText(words);
}

std::string numbered(const char* function, const char* what, std::size_t number) {
    return std::string(function) + ": " + what + " " + std::to_string(number);
}

}  // namespace

void GlobalIllumination::Implementation::requireMesh(std::size_t mesh, const std::string& where) const {
    if (mesh < meshes.size() && meshes[mesh].exists) return;
    throw Error(where + ": there is no mesh " + std::to_string(mesh) +
                "; give a number that addMesh() returned, or an index of SceneDescription::meshes");
}

void GlobalIllumination::Implementation::requireMaterial(std::size_t material,
                                                         const std::string& where) const {
    if (material < materials.size() && materials[material]) return;
    throw Error(where + ": there is no material " + std::to_string(material) +
                "; give a number that addMaterial() returned, or an index of SceneDescription::materials");
}

unsigned GlobalIllumination::Implementation::featuresFor(const Material& material, bool hasColors,
                                                         const std::string& name) const {
    const SceneFeatures& scene = renderer->features();
    const auto isKnown = [&](unsigned features) {
        return std::count(scene.materialFeatures.begin(), scene.materialFeatures.end(), features) > 0;
    };
    if (material.isGlossy() && !scene.glossy)
        throw Error(name +
                    " is glossy, and no material of SceneDescription::materials is; describe one "
                    "that is, which no mesh needs to use");
    const float brightest = std::max({material.emissive.r, material.emissive.g, material.emissive.b});
    if (material.emissive != glm::vec3(0.0F) && brightest > 1.0001F * renderer->maxEmission())
        throw Error(name + " emits " + numberText(double{brightest}) +
                    ", and the brightest of SceneDescription::materials emits " +
                    numberText(double{renderer->maxEmission()}) +
                    "; describe one that emits as much, which no mesh needs to use");
    unsigned features = materialFeatures(material) & ~unsigned{featureVertexColors};
    if (scene.has(featurePunctualLights)) features |= featurePunctualLights;
    if (!hasColors && isKnown(features)) return features;
    // Vertices without colours are white.
    if (isKnown(features | featureVertexColors)) return features | featureVertexColors;
    if (hasColors) features |= featureVertexColors;
    throw Error(name + " is of a kind that no material of SceneDescription::materials is: " +
                kindText(features) + "; describe one of this kind, which no instance needs to use");
}

Material GlobalIllumination::Implementation::withTextures(const MaterialDescription& description,
                                                          const std::string& name, std::size_t replaced) {
    std::vector<bool> isUsed(textures.size());
    for (std::size_t i = 0; i < materials.size(); ++i)
        if (i != replaced && materials[i])
            for (const int texture : {materials[i]->baseColorTexture, materials[i]->emissiveTexture,
                                      materials[i]->glossTexture, materials[i]->normalTexture})
                if (texture >= 0) isUsed[static_cast<std::size_t>(texture)] = true;
    std::vector<Texture> places = textures;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!isUsed[i]) places[i].external = 0;
    requireTextures(description, name);
    Material material = materialOf(description, name, places);
    textures = std::move(places);
    for (std::size_t i = 0; i < textures.size(); ++i)
        renderer->setTexture(i, textures[i].external);
    return material;
}

std::size_t GlobalIllumination::addMaterial(const MaterialDescription& description) {
    Implementation& implementation = ready(implementation_, "addMaterial");
    const SavedState saved;
    std::vector<std::optional<Material>>& materials = implementation.materials;
    const std::size_t number = freeNumber(materials, implementation.describedMaterials,
                                          [](const auto& material) { return !material; });
    const std::string name = "addMaterial: the material";
    const Material material = implementation.withTextures(description, name, number);
    implementation.featuresFor(material, false, name);
    materials.resize(std::max(materials.size(), number + 1));
    materials[number] = material;
    return number;
}

void GlobalIllumination::removeMaterial(std::size_t material) {
    Implementation& implementation = ready(implementation_, "removeMaterial");
    implementation.requireMaterial(material, "removeMaterial");
    const std::string name = numbered("removeMaterial", "material", material);
    if (material < implementation.describedMaterials)
        throw Error(name + " was described with the scene; only those of addMaterial() can be removed");
    for (std::size_t i = 0; i < implementation.meshes.size(); ++i)
        if (implementation.meshes[i].exists && implementation.meshes[i].material == material)
            throw Error(name + " is that of mesh " + std::to_string(i) + "; remove the mesh first");
    implementation.materials[material].reset();
}

void GlobalIllumination::setMaterial(std::size_t number, const MaterialDescription& description) {
    Implementation& implementation = ready(implementation_, "setMaterial");
    implementation.requireMaterial(number, "setMaterial");
    const SavedState saved;
    const std::string name = numbered("setMaterial", "material", number);
    Material& material = implementation.materials[number].value();
    const std::vector<Texture> before = implementation.textures;
    Material changed = implementation.withTextures(description, name, number);
    changed.vertexColors = material.vertexColors;
    std::vector<unsigned> features(implementation.meshes.size());
    try {
        implementation.featuresFor(changed, false, name);
        for (std::size_t i = 0; i < implementation.meshes.size(); ++i) {
            const Implementation::MeshState& mesh = implementation.meshes[i];
            if (!mesh.exists || mesh.material != number) continue;
            features[i] = implementation.featuresFor(changed, mesh.hasColors, name);
            if (hasTextures(changed) && !mesh.hasTextureCoordinates)
                throw Error(name + " has textures, and mesh " + std::to_string(i) +
                            " has no textureCoordinates; give it some, or leave out the textures");
        }
    } catch (...) {
        implementation.textures = before;
        for (std::size_t i = 0; i < before.size(); ++i)
            implementation.renderer->setTexture(i, before[i].external);
        throw;
    }
    material = changed;
    for (std::size_t i = 0; i < implementation.instances.size(); ++i) {
        const Implementation::InstanceState& instance = implementation.instances[i];
        if (!instance.exists || implementation.meshes[instance.mesh].material != number) continue;
        implementation.renderer->setMaterial(i, changed, features[instance.mesh]);
    }
}

std::size_t GlobalIllumination::addMesh(const MeshDescription& description) {
    Implementation& implementation = ready(implementation_, "addMesh");
    const std::string name = "addMesh: the mesh";
    if (implementation.maxInstances == implementation.describedInstances)
        throw Error("addMesh: the scene has no room for more instances; set SceneDescription::maxInstances");
    if (description.deforms)
        throw Error(name + " has `deforms`; describe it in SceneDescription::meshes, with a hidden instance");
    implementation.requireMaterial(description.material, "addMesh");
    const Material& material = implementation.materials[description.material].value();
    const Mesh mesh = meshOf(description, material, name);
    implementation.featuresFor(material, !description.colors.empty(),
                               name + " with material " + std::to_string(description.material));
    const SavedState saved;
    std::vector<Implementation::MeshState>& meshes = implementation.meshes;
    const std::size_t number =
        freeNumber(meshes, 0, [](const Implementation::MeshState& state) { return !state.exists; });
    implementation.renderer->addMesh(number, mesh);
    meshes.resize(std::max(meshes.size(), number + 1));
    meshes[number] = {.material = description.material,
                      .vertices = mesh.vertices.size(),
                      .isAdded = true,
                      .hasColors = !description.colors.empty(),
                      .hasTextureCoordinates = !description.textureCoordinates.empty()};
    return number;
}

void GlobalIllumination::removeMesh(std::size_t mesh) {
    Implementation& implementation = ready(implementation_, "removeMesh");
    implementation.requireMesh(mesh, "removeMesh");
    const std::string name = numbered("removeMesh", "mesh", mesh);
    if (!implementation.meshes[mesh].isAdded)
        throw Error(name + " was described with the scene; only those of addMesh() can be removed");
    for (std::size_t i = 0; i < implementation.instances.size(); ++i)
        if (implementation.instances[i].exists && implementation.instances[i].mesh == mesh)
            throw Error(name + " is that of instance " + std::to_string(i) + "; remove the instance first");
    implementation.renderer->removeMesh(mesh);
    implementation.meshes[mesh].exists = false;
}

std::size_t GlobalIllumination::addInstance(const InstanceDescription& description) {
    Implementation& implementation = ready(implementation_, "addInstance");
    std::vector<Implementation::InstanceState>& instances = implementation.instances;
    const auto isFree = [](const Implementation::InstanceState& state) { return !state.exists; };
    const std::size_t number = freeNumber(instances, 0, isFree);
    if (number >= implementation.maxInstances)
        throw Error("addInstance: the scene has " + std::to_string(number) +
                    " instances already; remove one, or raise SceneDescription::maxInstances");
    implementation.requireMesh(description.mesh, "addInstance");
    const Implementation::MeshState& mesh = implementation.meshes[description.mesh];
    if (mesh.deforms)
        throw Error("addInstance: mesh " + std::to_string(description.mesh) +
                    " has `deforms`, and so only the instance that it was described with");
    Instance instance;
    instance.mesh = static_cast<int>(description.mesh);
    instance.worldFromObject = affine(description.worldFromObject, "addInstance: the transform");
    const Material& material = implementation.materials[mesh.material].value();
    const unsigned features =
        implementation.featuresFor(material, mesh.hasColors, "addInstance: the material");
    // The node of an instance that was removed, or a new one.
    const std::size_t nodes = implementation.pose.worldFromNode.size();
    std::vector<bool> isTaken(nodes);
    for (const Implementation::InstanceState& state : instances)
        if (state.exists && state.node >= 0) isTaken[static_cast<std::size_t>(state.node)] = true;
    const std::size_t node = freeNumber(isTaken, 0, [](bool taken) { return !taken; });
    instance.node = static_cast<int>(node);
    const SavedState saved;
    implementation.renderer->addInstance(number, instance, material, features);
    implementation.pose.worldFromNode.resize(std::max(nodes, node + 1));
    implementation.pose.worldFromNode[node] = instance.worldFromObject;
    implementation.renderer->setPose(implementation.pose);
    implementation.appearances.resize(std::max(nodes, node + 1));
    instances.resize(std::max(instances.size(), number + 1));
    instances[number] = {.mesh = description.mesh, .node = instance.node, .isAdded = true};
    implementation.setAppearance(instance.node, description.isVisible, 1.0F);
    return number;
}

void GlobalIllumination::removeInstance(std::size_t instance) {
    Implementation& implementation = ready(implementation_, "removeInstance");
    implementation.requireInstance(instance, "removeInstance");
    if (!implementation.instances[instance].isAdded)
        throw Error(numbered("removeInstance", "instance", instance) +
                    " was described with the scene; hide it with setVisible()");
    const SavedState saved;
    implementation.renderer->removeInstance(instance);
    implementation.instances[instance].exists = false;
}

}  // namespace vct
