// What a file may be packed with beside glTF's own forms. Each is read by its own library, which a build may
// lack (CMake's VCT_DRACO, VCT_MESHOPT, VCT_WEBP and VCT_KTX); what needs it is then refused with the
// library's name.
#pragma once

#include <optional>
#include <vector>

#include "scene/gltf_file.h"

namespace vct {

// The extension by which meshoptimizer packs an object, a buffer view or a buffer; null where there is none.
const tinygltf::Value* meshoptOf(const tinygltf::ExtensionMap& extensions);

// Whether this build has the library.
extern const bool canUnpackMeshopt;

// The bytes of the buffer view `index`, which `packing`, its meshoptOf(), describes. They are counted. Throws
// where the view is damaged or the build lacks the library.
std::vector<unsigned char> unpackMeshopt(GltfFile& file, int index, const tinygltf::Value& packing);

// Of the document, before tinygltf, which refuses indices without a buffer view: hides those of primitives
// that Draco packs, until unpackDraco().
void hideDracoIndices(nlohmann::json& document);

// Puts what a Draco stream holds of a primitive into file.unpackedAccessors, and says how to read it: by the
// primitive that is returned, a list of triangles. Nothing where the primitive is not packed. A build without
// the library returns what the file holds plain as well; it throws where there is nothing. `mesh`: names it
// in an error.
std::optional<tinygltf::Primitive> unpackDraco(GltfFile& file, const tinygltf::Primitive& primitive,
                                               const std::string& mesh);

// The image of a texture: the WebP one where there is one that can be read, else the plain one, else the KTX2
// one. Throws where there is none.
int imageOf(const GltfFile& file, int texture);

}  // namespace vct
