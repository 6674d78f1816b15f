// Skins and morph targets of a glTF file.
#pragma once

#include <map>

#include "scene/gltf_file.h"
#include "scene/gltf_nodes.h"

namespace vct {

// The influences and targets of a primitive; null where it has neither. Positions, normals and joints are
// left to DeformedMeshes.
std::shared_ptr<Deformation> loadDeformation(GltfFile& file, const tinygltf::Primitive& primitive,
                                             std::size_t vertexCount);

// Makes meshes that nodes deform.
class DeformedMeshes {
  public:
    DeformedMeshes(GltfFile& file, const std::vector<PlacedNode>& nodes);

    // Whether the node shows `mesh` otherwise than as it is modelled.
    bool deforms(const PlacedNode& placed, const Mesh& mesh) const;
    // `mesh` as the node shows it at rest, in world space. Mesh::deformation is set where that can change.
    Mesh at(const PlacedNode& placed, const Mesh& mesh);

  private:
    const std::vector<Joint>& jointsOf(int skin);

    GltfFile& file_;
    std::map<int, const PlacedNode*> placedOf_;  // by the node's index in the file
    std::map<int, std::vector<Joint>> skins_;    // by index in the file
};

}  // namespace vct
