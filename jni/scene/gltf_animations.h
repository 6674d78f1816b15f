// The animations of a glTF file.
#pragma once

#include "scene/gltf_nodes.h"

namespace vct {

// The animation `nameOrIndex` ("" takes the first; where the file has none, there is none), and in `placed`
// which nodes it moves. Throws where there is no such animation, or where it is not valid; warns of those
// that are not played.
Animation loadAnimation(GltfFile& file, const std::string& nameOrIndex, std::vector<PlacedNode>& placed);

}  // namespace vct
