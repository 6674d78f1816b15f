// Loads the lights of a glTF file (KHR_lights_punctual).
#pragma once

#include "scene/gltf_nodes.h"

namespace vct {

// Adds the light of a node to the scene, the first directional light as the sun. Leaves out a light without
// intensity, and, with a warning, one that needs a direction and has none.
void addLight(GltfFile& file, const PlacedNode& placed, Scene& scene);

}  // namespace vct
