// Compression formats beyond core glTF. Each needs a library, which a build may lack (CMake's VCT_DRACO,
// VCT_MESHOPT and VCT_WEBP). Such a build refuses files that need the library, and names it.
#pragma once

#include <optional>
#include <vector>

#include "scene/gltf_file.h"

namespace vct {

// Returns the meshoptimizer extension of a buffer view or a buffer, or null if it has none.
const tinygltf::Value* meshoptOf(const tinygltf::ExtensionMap& extensions);

// True if this build has meshoptimizer.
extern const bool canUnpackMeshopt;

// Decompresses the buffer view `index`. `packing` is its meshoptOf(). Counts the memory. Throws vct::Error if
// the view is damaged or the build lacks the library.
std::vector<unsigned char> unpackMeshopt(GltfFile& file, int index, const tinygltf::Value& packing);

// Decompresses a primitive's Draco stream into file.unpackedAccessors, and returns the primitive to load from
// them, a list of triangles. Returns nothing if the primitive is not compressed. A build without the library
// returns the uncompressed primitive if the file also holds one, and throws vct::Error otherwise. `mesh`
// names the mesh in an error.
std::optional<tinygltf::Primitive> unpackDraco(GltfFile& file, const tinygltf::Primitive& primitive,
                                               const std::string& mesh);

// Returns the index of a texture's image: its WebP image if this build can read it, else its PNG or JPEG
// image. Throws vct::Error if there is none.
int imageOf(const GltfFile& file, int texture);

}  // namespace vct
