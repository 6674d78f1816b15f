#include "model.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>

namespace {

// The elements of an accessor, converted to `Element`, whose components are floats or integers.
template <class Element>
std::vector<Element> elements(const tinygltf::Model& file, int index) {
    const tinygltf::Accessor& accessor = file.accessors.at(static_cast<std::size_t>(index));
    const tinygltf::BufferView& view = file.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
    const unsigned char* data = file.buffers.at(static_cast<std::size_t>(view.buffer)).data.data() +
                                view.byteOffset + accessor.byteOffset;
    const auto stride = static_cast<std::size_t>(accessor.ByteStride(view));
    const int components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type));
    using Number = typename Element::value_type;
    std::vector<Element> result(accessor.count);
    for (std::size_t i = 0; i < accessor.count; ++i)
        for (int c = 0; c < components; ++c) {
            const unsigned char* at = data + i * stride;
            Number& number = reinterpret_cast<Number*>(&result[i])[c];
            if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT)
                number = static_cast<Number>(reinterpret_cast<const float*>(at)[c]);
            else if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT)
                number = static_cast<Number>(reinterpret_cast<const std::uint16_t*>(at)[c]);
            else
                number = static_cast<Number>(at[c]);
        }
    return result;
}

glm::vec3 vectorOf(const std::vector<double>& numbers, glm::vec3 instead) {
    return numbers.size() < 3 ? instead : glm::vec3(numbers[0], numbers[1], numbers[2]);
}

Surface surfaceOf(const tinygltf::Model& file, const tinygltf::Material& material) {
    Surface surface;
    surface.baseColor = vectorOf(material.pbrMetallicRoughness.baseColorFactor, glm::vec3(1));
    surface.emission = vectorOf(material.emissiveFactor, glm::vec3(0));
    const auto strength = material.extensions.find("KHR_materials_emissive_strength");
    if (strength != material.extensions.end())
        surface.emission *= static_cast<float>(strength->second.Get("emissiveStrength").GetNumberAsDouble());
    const int texture = material.pbrMetallicRoughness.baseColorTexture.index;
    if (texture >= 0) surface.picture = file.textures.at(static_cast<std::size_t>(texture)).source;
    return surface;
}

Part partOf(const tinygltf::Model& file, const tinygltf::Primitive& primitive) {
    const auto read = [&]<class Element>(const char* name, std::vector<Element>& values) {
        const auto found = primitive.attributes.find(name);
        if (found != primitive.attributes.end()) values = elements<Element>(file, found->second);
    };
    Part part;
    part.surface = static_cast<std::size_t>(primitive.material);
    read("POSITION", part.positions);
    read("NORMAL", part.normals);
    read("TEXCOORD_0", part.coordinates);
    read("JOINTS_0", part.joints);
    read("WEIGHTS_0", part.weights);
    for (const glm::uvec1 index : elements<glm::uvec1>(file, primitive.indices))
        part.indices.push_back(index.x);
    return part;
}

}  // namespace

Model::Model(const std::string& path) {
    tinygltf::Model file;
    std::string error, warning;
    if (!tinygltf::TinyGLTF().LoadBinaryFromFile(&file, &error, &warning, path))
        throw std::runtime_error("cannot read " + path + ": " + error);
    for (const tinygltf::Image& image : file.images)
        pictures.push_back({image.width, image.height, image.image});
    for (const tinygltf::Material& material : file.materials)
        surfaces.push_back(surfaceOf(file, material));
    nodes.resize(file.nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const tinygltf::Node& node = file.nodes[i];
        for (const int child : node.children)
            nodes.at(static_cast<std::size_t>(child)).parent = static_cast<int>(i);
        nodes[i].translation = vectorOf(node.translation, nodes[i].translation);
        nodes[i].scale = vectorOf(node.scale, nodes[i].scale);
        if (const std::vector<double>& q = node.rotation; q.size() == 4)
            nodes[i].rotation = glm::quat(glm::dquat(q[3], q[0], q[1], q[2]));
        if (node.mesh >= 0)
            for (const tinygltf::Primitive& primitive :
                 file.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
                parts.push_back(partOf(file, primitive));
                parts.back().name = node.name;
                parts.back().node = static_cast<int>(i);
                parts.back().hasSkin = node.skin >= 0;
            }
    }
    for (const tinygltf::Skin& skin : file.skins) {
        jointNodes = skin.joints;
        inverseBind = elements<glm::mat4>(file, skin.inverseBindMatrices);
    }
    for (const tinygltf::Animation& animation : file.animations)
        for (const tinygltf::AnimationChannel& channel : animation.channels) {
            const tinygltf::AnimationSampler& sampler =
                animation.samplers[static_cast<std::size_t>(channel.sampler)];
            Channel keys{channel.target_node, channel.target_path == "rotation", {}, {}};
            for (const glm::vec1 time : elements<glm::vec1>(file, sampler.input))
                keys.times.push_back(time.x);
            keys.values = elements<glm::vec4>(file, sampler.output);
            channels.push_back(std::move(keys));
        }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const glm::mat4 world = worldFromNode(static_cast<int>(i));
        if (file.nodes[i].camera >= 0) {
            worldFromCamera = world;
            verticalFovRad = static_cast<float>(
                file.cameras[static_cast<std::size_t>(file.nodes[i].camera)].perspective.yfov);
        }
        const auto light = file.nodes[i].extensions.find("KHR_lights_punctual");
        if (light == file.nodes[i].extensions.end()) continue;
        const tinygltf::Light& sun =
            file.lights.at(static_cast<std::size_t>(light->second.Get("light").GetNumberAsInt()));
        directionToSun = glm::normalize(glm::vec3(world[2]));
        sunColor = vectorOf(sun.color, sunColor);
        sunIlluminance = static_cast<float>(sun.intensity);
    }
}

void Model::animate(float seconds) {
    for (const Channel& channel : channels) {
        const float time = std::fmod(seconds, channel.times.back());
        const auto next = std::upper_bound(channel.times.begin(), channel.times.end() - 1, time);
        const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - channel.times.begin(), 1));
        const float before = channel.times[i - 1],
                    share = glm::clamp((time - before) / (channel.times[i] - before), 0.0F, 1.0F);
        const glm::vec4 a = channel.values[i - 1], b = channel.values[i];
        Node& node = nodes[static_cast<std::size_t>(channel.node)];
        if (channel.isRotation)
            node.rotation = glm::slerp(glm::quat(a.w, a.x, a.y, a.z), glm::quat(b.w, b.x, b.y, b.z), share);
        else
            node.translation = glm::mix(a, b, share);
    }
}

glm::mat4 Model::worldFromNode(int index) const {
    const Node& node = nodes.at(static_cast<std::size_t>(index));
    const glm::mat4 local = glm::scale(
        glm::translate(glm::mat4(1.0F), node.translation) * glm::mat4_cast(node.rotation), node.scale);
    return node.parent < 0 ? local : worldFromNode(node.parent) * local;
}

void Model::deform(const Part& part, std::vector<glm::vec3>& positions,
                   std::vector<glm::vec3>& normals) const {
    std::vector<glm::mat4> matrices;
    for (std::size_t joint = 0; joint < jointNodes.size(); ++joint)
        matrices.push_back(worldFromNode(jointNodes[joint]) * inverseBind[joint]);
    positions.resize(part.positions.size());
    normals.resize(part.positions.size());
    for (std::size_t i = 0; i < part.positions.size(); ++i) {
        glm::mat4 matrix(0.0F);
        for (int k = 0; k < 4; ++k)
            matrix += part.weights[i][k] * matrices[part.joints[i][k]];
        positions[i] = matrix * glm::vec4(part.positions[i], 1);
        normals[i] = glm::normalize(glm::mat3(matrix) * part.normals[i]);
    }
}
