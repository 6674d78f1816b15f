// Lights of a glTF file: KHR_lights_punctual.
#pragma once

#include "scene/gltf_nodes.h"

namespace vct {

// The light of a node, added to the scene: the first directional one as its sun. One that gives no light, or
// has no direction where it needs one, is warned of.
void addLight(GltfFile& file, const PlacedNode& placed, Scene& scene);

}  // namespace vct
