#include "scene/gltf_names.h"

#include "scene/gltf_file.h"

namespace vct {

GltfNames namesOfGltf(const std::string& path, const ReadFile& readFile, const GltfOptions& options) {
    const std::vector<unsigned char> bytes = readFile(path);
    const GltfFile file = openGltf(path, bytes, readFile, options.allowOutside);
    GltfNames names;
    for (std::size_t i = 0; i < file.animations.size(); ++i)
        names.animations.push_back(indexAndName(i, textAt(file.animations[i], "name")));
    const auto extension = file.model.extensions.find("KHR_materials_variants");
    if (extension == file.model.extensions.end() || !extension->second.Has("variants")) return names;
    const tinygltf::Value& variants = extension->second.Get("variants");
    for (std::size_t i = 0; i < variants.ArrayLen(); ++i) {
        const tinygltf::Value& name = variants.Get(static_cast<int>(i)).Get("name");
        names.variants.push_back(name.IsString() ? oneLine(name.Get<std::string>()) : std::to_string(i));
    }
    return names;
}

}  // namespace vct
