#include "scene/gltf_instancing.h"

#include <cmath>

#include "scene/gltf_accessors.h"
#include "scene/gltf_extensions.h"

namespace vct {

std::optional<std::vector<NodeTransform>> instancesIn(GltfFile& file, const tinygltf::Node& node) {
    const tinygltf::Value* const extension = extensionOf(node.extensions, "EXT_mesh_gpu_instancing");
    if (extension == nullptr) return std::nullopt;
    const auto index = static_cast<std::size_t>(&node - file.model.nodes.data());
    const std::string name = "node " + indexAndName(index, node.name) + " (instances)";
    if (!extension->IsObject() || !extension->Has("attributes") || !extension->Get("attributes").IsObject())
        file.fail(name + " has no attributes");
    const tinygltf::Value& attributes = extension->Get("attributes");

    std::optional<std::size_t> count;
    for (const std::string& attribute : attributes.Keys()) {
        const int accessor = indexAt(attributes, attribute.c_str());
        const std::size_t elements = file.at(file.model.accessors, accessor, "accessor").count;
        if (count && *count != elements)
            file.fail(name + " has attributes of different lengths: " + std::to_string(*count) + " and " +
                      std::to_string(elements));
        count = elements;
        const bool known = attribute == "TRANSLATION" || attribute == "ROTATION" || attribute == "SCALE";
        // Attributes that begin with an underscore are private data of other programs.
        if (!known && attribute[0] != '_')
            file.warn("attributes of instances other than TRANSLATION, ROTATION and SCALE are ignored");
    }

    const auto values = [&](const char* attribute, int width, Components components) {
        std::vector<float> result;
        if (attributes.Has(attribute))
            result =
                readFloats(file, indexAt(attributes, attribute), width, components, name + ", " + attribute);
        for (const float value : result)
            if (!(std::abs(value) <= 1e30F))
                file.fail(name + " has a " + attribute + " that is not a usable number");
        return result;
    };
    const std::vector<float> translations = values("TRANSLATION", 3, Components::floatOnly);
    const std::vector<float> rotations = values("ROTATION", 4, Components::floatOrNormalized);
    const std::vector<float> scales = values("SCALE", 3, Components::floatOnly);

    file.reserveGeometry(count.value_or(0), sizeof(NodeTransform));
    std::vector<NodeTransform> transforms(count.value_or(0));
    for (std::size_t i = 0; i < transforms.size(); ++i) {
        const float *t = translations.data() + 3 * i, *r = rotations.data() + 4 * i,
                    *s = scales.data() + 3 * i;
        if (!translations.empty()) transforms[i].translation = glm::dvec3(t[0], t[1], t[2]);
        if (!scales.empty()) transforms[i].scale = glm::dvec3(s[0], s[1], s[2]);
        if (rotations.empty()) continue;
        const glm::dquat rotation(r[3], r[0], r[1], r[2]);
        const double length = glm::length(rotation);
        if (!(length > 1e-6))
            file.fail(name + " has a ROTATION that is not a unit quaternion: that of instance " +
                      std::to_string(i));
        transforms[i].rotation = rotation / length;
    }
    return transforms;
}

}  // namespace vct
