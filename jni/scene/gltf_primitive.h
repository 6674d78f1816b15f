// One glTF primitive as a Mesh.
#pragma once

#include <optional>

#include "scene/gltf_file.h"
#include "scene/gltf_materials.h"

namespace vct {

// `meshIndex`: of the mesh that the primitive is of, which must exist. Nothing where the primitive has no
// triangles (points and lines are left out with a warning).
std::optional<Mesh> loadPrimitive(GltfFile& file, const tinygltf::Primitive& primitive,
                                  MaterialLoader& materials, std::size_t meshIndex);

}  // namespace vct
