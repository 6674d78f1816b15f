// What a glTF file says of extensions: which it uses, and which it requires.
#pragma once

#include "scene/gltf_file.h"

namespace vct {

// Of the document: warns of what is ignored, keeps what it requires of that in file.missingExtensions, and
// takes both lists out of it. Most of what files require changes how they look, and what holds their
// triangles or images is refused where it is met.
void checkExtensions(GltfFile& file, nlohmann::json& document);

// The extension `name` of one of the model's objects; null where it has none.
const tinygltf::Value* extensionOf(const tinygltf::ExtensionMap& extensions, const char* name);

// The whole number at `key` of an extension's object, 0 to 2^31 - 1; -1 where there is none.
int indexAt(const tinygltf::Value& object, const char* key);

}  // namespace vct
