// Extensions of a glTF file: checks which are used and required, and finds them in objects.
#pragma once

#include "scene/gltf_file.h"

namespace vct {

// Warns about extensions of the document that are not supported, stores the required ones among them in
// file.missingExtensions, and removes both lists from the document. It does not refuse the file: most
// required extensions change only the look of the scene, and an extension that holds triangles or images is
// refused when these are loaded.
void checkExtensions(GltfFile& file, nlohmann::json& document);

// Returns the extension `name` of one of the model's objects, or null if it has none.
const tinygltf::Value* extensionOf(const tinygltf::ExtensionMap& extensions, const char* name);

// Returns the whole number at `key` of an extension's object, 0 to 2^31 - 1, or -1 if there is none.
int indexAt(const tinygltf::Value& object, const char* key);

}  // namespace vct
