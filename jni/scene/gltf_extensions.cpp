#include "scene/gltf_extensions.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>

#include "core/list_text.h"

namespace vct {
namespace {

using nlohmann::json;

const char* const supportedExtensions[] = {
    "KHR_lights_punctual",        "EXT_mesh_gpu_instancing", "KHR_draco_mesh_compression",
    "EXT_meshopt_compression",    "KHR_meshopt_compression", "EXT_texture_webp",
    "KHR_texture_basisu",         "KHR_texture_transform",   "KHR_materials_emissive_strength",
    "KHR_mesh_quantization",      "KHR_materials_unlit",     "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_transmission", "KHR_node_visibility"};

}  // namespace

void checkExtensions(GltfFile& file, json& document) {
    const auto names = [&](const char* key) {
        std::vector<std::string> result;
        const auto found = document.find(key);
        if (found == document.end() || !found->is_array()) return result;
        for (const json& name : *found) {
            if (!name.is_string()) continue;
            const std::string extension = name.get<std::string>();
            const bool supported = std::find(std::begin(supportedExtensions), std::end(supportedExtensions),
                                             extension) != std::end(supportedExtensions);
            if (!supported) result.push_back(oneLine(extension));
        }
        return result;
    };
    const std::vector<std::string> missing = names("extensionsRequired");
    if (!missing.empty()) {
        file.missingExtensions = listText(missing);
        file.warn("the file requires unsupported extensions, so the picture lacks what they add: " +
                  file.missingExtensions);
    }
    std::vector<std::string> ignored = names("extensionsUsed");
    const std::set<std::string> said(missing.begin(), missing.end());
    ignored.erase(std::remove_if(ignored.begin(), ignored.end(),
                                 [&](const std::string& name) { return said.count(name) != 0; }),
                  ignored.end());
    if (ignored.size() == 1) file.warn("extension " + ignored[0] + " is ignored");
    if (ignored.size() > 1)
        file.warn(std::to_string(ignored.size()) + " extensions are ignored: " + listText(ignored));
    const auto used = document.find("extensionsUsed");
    file.isQuantized = used != document.end() && used->is_array() &&
                       std::find(used->begin(), used->end(), "KHR_mesh_quantization") != used->end();
    // tinygltf does not need these lists.
    document.erase("extensionsUsed");
    document.erase("extensionsRequired");
}

const tinygltf::Value* extensionOf(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto found = extensions.find(name);
    return found == extensions.end() ? nullptr : &found->second;
}

int indexAt(const tinygltf::Value& object, const char* key) {
    if (!object.IsObject() || !object.Has(key)) return -1;
    const tinygltf::Value& value = object.Get(key);
    return value.IsInt() ? std::max(value.GetNumberAsInt(), -1) : -1;
}

}  // namespace vct
