// EXT_mesh_gpu_instancing: one node that places its mesh many times.
#pragma once

#include <optional>
#include <vector>

#include "scene/gltf_file.h"

namespace vct {

// How the instances of a node's mesh lie in the node. Nothing where the node has no such extension; then its
// mesh lies in it once. Throws where the attributes are not as the extension has them.
std::optional<std::vector<NodeTransform>> instancesIn(GltfFile& file, const tinygltf::Node& node);

}  // namespace vct
