// The animations of a glTF file.
#pragma once

#include <nlohmann/json.hpp>

#include "scene/gltf_nodes.h"

namespace vct {

// The file's list of animations into file.model, -1 or "" where a property is missing. In place of
// tinygltf, which drops what it cannot read and does not say of which animation it was.
void readAnimations(GltfFile& file, const nlohmann::json& animations);

// The animation `nameOrIndex` ("" takes the first; where the file has none, there is none), and in `placed`
// which nodes it moves. Throws where there is no such animation, or where it is not valid; warns of those
// that are not played.
Animation loadAnimation(GltfFile& file, const std::string& nameOrIndex, std::vector<PlacedNode>& placed);

}  // namespace vct
