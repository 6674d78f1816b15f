// Loads EXT_mesh_gpu_instancing, by which one node places its mesh many times.
#pragma once

#include <optional>
#include <vector>

#include "scene/gltf_file.h"

namespace vct {

// Returns the transforms of the mesh's instances relative to the node. Returns nothing if the node does not
// have the extension. Throws vct::Error if the attributes do not conform to the extension.
std::optional<std::vector<NodeTransform>> instancesIn(GltfFile& file, const tinygltf::Node& node);

}  // namespace vct
