// Loads skins and morph targets of a glTF file.
#pragma once

#include <map>

#include "scene/gltf_accessors.h"
#include "scene/gltf_file.h"
#include "scene/gltf_nodes.h"

namespace vct {

// Loads the influences and targets of a primitive. Returns null if it has neither. DeformedMeshes adds
// positions, normals and joints.
std::shared_ptr<Deformation> loadDeformation(GltfFile& file, const tinygltf::Primitive& primitive,
                                             const VertexChoice& vertices);

// Makes meshes that nodes deform.
class DeformedMeshes {
  public:
    DeformedMeshes(GltfFile& file, const std::vector<PlacedNode>& nodes);

    // True if the node deforms `mesh`, at rest or in the animation.
    bool deforms(const PlacedNode& placed, const Mesh& mesh) const;
    // Returns `mesh` as the node deforms it at rest, in world space. Mesh::deformation is set only if the
    // animation can change it.
    Mesh at(const PlacedNode& placed, const Mesh& mesh);

  private:
    const std::vector<Joint>& jointsOf(int skin);
    // Throws vct::Error if vertices follow a joint whose matrix is not usable. Replaces the matrices of
    // joints that no vertex follows, because exporters write anything there.
    void checkFollowed(int skin, Deformation& deformation) const;

    GltfFile& file_;
    std::map<int, const PlacedNode*> placedOf_;  // key: index of the node in the file
    std::map<int, std::vector<Joint>> skins_;    // key: index of the skin in the file
};

}  // namespace vct
